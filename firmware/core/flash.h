/* Tables that stay in the program memory of a controller that has one. */
#ifndef WB_FLASH_H
#define WB_FLASH_H

#ifdef __AVR__
#define WB_FLASH __flash
#else
#define WB_FLASH
#endif

#endif
