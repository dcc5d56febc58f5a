#ifndef EXPORTED_VISIBILITY_H
#define EXPORTED_VISIBILITY_H
#define EXPORTED_PUBLIC __attribute__((visibility("default")))
#define EXPORTED_LOCAL __attribute__((visibility("hidden")))
#define EXPORTED_SUFFIX "!"
#endif
