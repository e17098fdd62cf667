/* What the core asks of the compiler beyond C11. */
#ifndef WB_COMPILER_H
#define WB_COMPILER_H

/* Marks tables that stay in program memory, where a controller has one of its own. */
#ifdef __AVR__
#define WB_FLASH __flash
#else
#define WB_FLASH
#endif

/* For what interrupts call: without a call an interrupt saves only the registers that it uses. */
#define WB_INLINE __attribute__((always_inline)) inline

#endif
