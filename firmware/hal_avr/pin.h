/* Access to the pins that the machine's file names by port letter and bit: one instruction each. */
#ifndef WB_PIN_H
#define WB_PIN_H

#include <avr/io.h>

#define WB_JOIN_(a, b) a##b
#define WB_PORT_(port, bit) WB_JOIN_(PORT, port)
#define WB_DDR_(port, bit) WB_JOIN_(DDR, port)
#define WB_PIN_(port, bit) WB_JOIN_(PIN, port)
#define WB_MASK_(port, bit) ((uint8_t)(1u << (bit)))
/* Variadic: by then the name of a pin has been expanded to its two parts. */
#define WB_PORT(...) WB_PORT_(__VA_ARGS__)
#define WB_DDR(...) WB_DDR_(__VA_ARGS__)
#define WB_PIN(...) WB_PIN_(__VA_ARGS__)
#define WB_MASK(...) WB_MASK_(__VA_ARGS__)

#define wb_pin_output(...) (WB_DDR(__VA_ARGS__) |= WB_MASK(__VA_ARGS__))
#define wb_pin_high(...) (WB_PORT(__VA_ARGS__) |= WB_MASK(__VA_ARGS__))
#define wb_pin_low(...) (WB_PORT(__VA_ARGS__) &= (uint8_t)~WB_MASK(__VA_ARGS__))
#define wb_pin_is_high(...) ((WB_PIN(__VA_ARGS__) & WB_MASK(__VA_ARGS__)) != 0)

#endif
