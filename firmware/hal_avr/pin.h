/* Pins by the names of the machine's file: port letter and bit, in one instruction where the port is known. */
#ifndef WB_PIN_H
#define WB_PIN_H

#include <avr/io.h>

#define WB_JOIN_(a, b) a##b
#define WB_PORT_(port, bit) WB_JOIN_(PORT, port)
#define WB_DDR_(port, bit) WB_JOIN_(DDR, port)
#define WB_PIN_(port, bit) WB_JOIN_(PIN, port)
#define WB_MASK_(port, bit) ((uint8_t)(1u << (bit)))
/* Variadic: the name of a pin has become its two parts by then. */
#define WB_PORT(...) WB_PORT_(__VA_ARGS__)
#define WB_DDR(...) WB_DDR_(__VA_ARGS__)
#define WB_PIN(...) WB_PIN_(__VA_ARGS__)
#define WB_MASK(...) WB_MASK_(__VA_ARGS__)

#define wb_pin_output(...) (WB_DDR(__VA_ARGS__) |= WB_MASK(__VA_ARGS__))
#define wb_pin_high(...) (WB_PORT(__VA_ARGS__) |= WB_MASK(__VA_ARGS__))
#define wb_pin_low(...) (WB_PORT(__VA_ARGS__) &= (uint8_t)~WB_MASK(__VA_ARGS__))
#define wb_pin_is_high(...) ((WB_PIN(__VA_ARGS__) & WB_MASK(__VA_ARGS__)) != 0)

#endif
