/*
 * The boundary between WireBend and a machine driver, in C.
 *
 * A driver is a shared library that exports one function, wirebend_driver_entry. Everything that
 * crosses the boundary is JSON in UTF-8, without a zero byte at its end; the JSON Schema of every message
 * is in crates/driver-api/schema/. Lengths are millimetres, angles degrees, times seconds.
 *
 * Memory. Bytes that the program hands in belong to it and are valid until the function returns. Bytes
 * that the driver hands out belong to the driver until the program hands them to `free`, which it
 * does once for every buffer. The description and the table may be static: then `free` does nothing.
 *
 * Threads. The program runs every driver in a process of its own, and calls all functions from one
 * thread, one at a time. The driver may have threads of its own. It does not end the process, and
 * nothing is to be thrown or jumped across the boundary.
 *
 * Time. Functions start something and return; what becomes of it comes by `poll`. A driver that misses
 * a deadline is ended, and its port is closed with it:
 *     description, from the start of the process   5 s
 *     open                                         2 s
 *     call "encode"                               30 s
 *     call "stop"                                100 ms
 *     any other call                               1 s
 *     poll                                         2 s
 *     close                                      500 ms
 *
 * Output. The standard output of the process goes where its standard error goes: to the console that the
 * program shows when a driver fails.
 */
#ifndef WIREBEND_DRIVER_H
#define WIREBEND_DRIVER_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Drivers and programs with the same major understand each other. */
#define WIREBEND_ABI_MAJOR 1u
/* A larger minor has more messages or extensions; nothing that was there has changed. 1.1 has more calls
   ("ports", "write-settings") and events ("settings-written", "made"), and keys with defaults in those of
   1.0: "resume" of "connect", "token" in the reply of "arm", "going_on" of "connected". 1.2 has the call "limits",
   and one key more, "reference" of "connected": "machine" (the default) or "person". 1.5 has the call and the event "speed",
   and the key "dry" of "jog", for drivers with the capabilities "speed" and "dry-run" alone. 1.6 has the
   capability "before-zero": "approach_deg" and "bend_deg" of a step may have one sign. 1.7 has the call "console" and the event
   "console-done", for drivers with the capability "console" alone, the call and the event "cut" and the key "cutter_mm" of
   "limits", for those with the capability "cut". docs/drivers.md has all of them. */
#define WIREBEND_ABI_MINOR 7u

/* What a function returns. */
#define WIREBEND_OK 0      /* done; the buffer holds the result */
#define WIREBEND_REFUSED 1 /* not done; the buffer holds {"code", "message", "help"} */

#if defined(_WIN32)
#define WIREBEND_EXPORT __declspec(dllexport)
#else
#define WIREBEND_EXPORT __attribute__((visibility("default")))
#endif

/* Bytes that the program owns. */
typedef struct wirebend_bytes {
    const uint8_t *data; /* null when len is 0 */
    size_t len;          /* bytes */
} wirebend_bytes;

/* Bytes that the driver owns until `free`. */
typedef struct wirebend_buffer {
    uint8_t *data; /* null when len is 0 */
    size_t len;    /* bytes; at most 64 MiB */
} wirebend_buffer;

/* What a driver can be asked. None of the functions may be null. */
typedef struct wirebend_driver {
    /* WIREBEND_ABI_MAJOR and WIREBEND_ABI_MINOR of the header that the driver was built with. */
    uint32_t abi_major;
    uint32_t abi_minor;

    /* Gives the description: id, name, version, capabilities, formats, settings_schema. Needs no machine
       and no settings, and is the same every time. */
    int32_t (*describe)(wirebend_buffer *out);

    /* Takes settings, a JSON object ({} for the defaults), and makes an instance. An unknown key is
       refused by name. On WIREBEND_OK *instance is not null and `out` may stay empty. */
    int32_t (*open)(wirebend_bytes settings, void **instance, wirebend_buffer *out);

    /* Takes a call, {"call": "encode", ...}, and gives its reply. A call that the driver does not know
       is refused with the code "unknown-call", one that its machine cannot do with "unsupported". */
    int32_t (*call)(void *instance, wirebend_bytes request, wirebend_buffer *out);

    /* Gives the next event, or an empty buffer when there is none. Never waits. */
    int32_t (*poll)(void *instance, wirebend_buffer *out);

    /* Ends an instance: the port is closed, memory is given back. */
    void (*close)(void *instance);

    /* Takes back a buffer that the driver filled; an empty one too. */
    void (*free)(wirebend_buffer buffer);

    /* Gives the table of a later feature by "name/revision", or null. The name ends with a zero byte. */
    const void *(*extension)(const char *name);
} wirebend_driver;

/* The one symbol of a driver. The table is valid for the life of the process. */
WIREBEND_EXPORT const wirebend_driver *wirebend_driver_entry(void);

#ifdef __cplusplus
}
#endif

#endif
