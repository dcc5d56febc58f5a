#ifndef RADIO_NAMES_H
#define RADIO_NAMES_H
namespace radio
{
namespace names
{
static const char ns[] = "radio";
static const char send[] = "send";
static const char received[] = "received";
}
}
#endif
