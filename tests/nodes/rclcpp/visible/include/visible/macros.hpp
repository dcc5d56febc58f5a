#ifndef VISIBLE__MACROS_HPP_
#define VISIBLE__MACROS_HPP_
#define VISIBLE_PUBLIC __attribute__((visibility("default")))
#define VISIBLE_LOCAL __attribute__((visibility("hidden")))
#define VISIBLE_OPEN namespace visible {
#define VISIBLE_CLOSE }
#define VISIBLE_UNIT "m"
#endif
