#pragma once
#include <memory>

/// What users of the library see.
class Hidden {
public:
    Hidden();
    ~Hidden();

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};
