#include "storage/settings.h"

#include "common/compiler.h"
#include "common/crc.h"
#include "hal.h"

/* Addresses of the two copies. Each has its own checksum: a reset or a loss of power in the middle of a write damages
 * one copy at most. The first copy is written first, so it is the newer one where both are valid and differ. */
static const WB_FLASH uint16_t COPY[2] = {256, 512};
/* Layout of a copy. Its version is erased before anything else of it changes, and written last. */
#define VERSION 0
#define MACHINE 1
#define VALUES 2
#define NO_VERSION 0xFF

/* Firmware 1.00 stored fewer settings, once. They are converted, with the defaults of those that it did not have. */
#define OLD_COPY 2
#define OLD_VERSION 1
#define OLD_COUNT 24

static const WB_FLASH struct {
    int32_t min; /* number in the unit of the setting */
    int32_t max; /* number in the unit of the setting */
} RANGE[WB_SETTINGS_COUNT] = {WB_SETTINGS_RANGES};
static const WB_FLASH int32_t DEFAULTS[WB_SETTINGS_COUNT] = {WB_MACHINE_DEFAULTS};

int32_t wb_setting(const struct wb_settings *settings, uint8_t id)
{
    return settings->value[id - 1];
}

static bool allowed(uint8_t index, int32_t value)
{
    return value >= RANGE[index].min && value <= RANGE[index].max;
}

/* What the moves rely on beyond the range of each setting. */
static bool consistent(const struct wb_settings *settings)
{
    int32_t home = wb_setting(settings, WB_SETTING_HOME_POSITION);
    int32_t limit = wb_setting(settings, WB_SETTING_BEND_LIMIT);
    return (home < 0 ? -home : home) >= limit && wb_setting(settings, WB_SETTING_NEAR_SIDE) <= limit &&
           wb_setting(settings, WB_SETTING_HOME_BACK_OFF) <= wb_setting(settings, WB_SETTING_HOME_TRAVEL);
}

/* Reads a copy of a version that has `count` values. Whether it is valid. */
static bool read_copy(struct wb_settings *settings, void *board, uint16_t copy, uint8_t version, uint8_t count)
{
    uint16_t sum = (uint16_t)(copy + VALUES + 4u * count);
    uint16_t crc = version;
    for (uint16_t at = copy; at < sum; at++) {
        crc = wb_crc16(crc, hal_stored(board, at));
    }
    uint16_t stored = (uint16_t)(hal_stored(board, sum) | hal_stored(board, (uint16_t)(sum + 1)) << 8);
    bool good = crc == stored && hal_stored(board, copy + VERSION) == version &&
                hal_stored(board, copy + MACHINE) == WB_MACHINE_ID;
    for (uint8_t i = 0; i < WB_SETTINGS_COUNT; i++) {
        uint32_t value = (uint32_t)DEFAULTS[i];
        for (uint8_t k = 4; i < count && k > 0; k--) {
            value = value << 8 | hal_stored(board, (uint16_t)(copy + VALUES + 4u * i + k - 1u));
        }
        settings->value[i] = (int32_t)value;
        good = good && allowed(i, settings->value[i]);
    }
    return good && consistent(settings);
}

static void write_copy(const struct wb_settings *settings, void *board, uint16_t copy)
{
    uint16_t crc = wb_crc16(WB_SETTINGS_VERSION, WB_SETTINGS_VERSION);
    hal_store(board, copy + VERSION, NO_VERSION);
    for (uint16_t at = MACHINE; at < VALUES + 4 * WB_SETTINGS_COUNT; at++) {
        uint8_t byte = WB_MACHINE_ID;
        if (at != MACHINE) {
            uint16_t offset = (uint16_t)(at - VALUES);
            byte = (uint8_t)((uint32_t)settings->value[offset / 4] >> (8 * (offset % 4)));
        }
        crc = wb_crc16(crc, byte);
        hal_store(board, (uint16_t)(copy + at), byte);
    }
    uint16_t sum = (uint16_t)(copy + VALUES + 4 * WB_SETTINGS_COUNT);
    hal_store(board, sum, (uint8_t)crc);
    hal_store(board, (uint16_t)(sum + 1), (uint8_t)(crc >> 8));
    hal_store(board, copy + VERSION, WB_SETTINGS_VERSION);
}

static void store(const struct wb_settings *settings, void *board)
{
    write_copy(settings, board, COPY[0]);
    write_copy(settings, board, COPY[1]);
    /* The old copy must not come back when both are damaged. */
    if (hal_stored(board, OLD_COPY + VERSION) == OLD_VERSION) {
        hal_store(board, OLD_COPY + VERSION, NO_VERSION);
    }
}

static bool copies_equal(void *board)
{
    for (uint16_t at = 0; at < VALUES + 4 * WB_SETTINGS_COUNT + 2; at++) {
        if (hal_stored(board, (uint16_t)(COPY[0] + at)) != hal_stored(board, (uint16_t)(COPY[1] + at))) {
            return false;
        }
    }
    return true;
}

void wb_settings_load(struct wb_settings *settings, void *board)
{
    bool first = read_copy(settings, board, COPY[0], WB_SETTINGS_VERSION, WB_SETTINGS_COUNT);
    settings->good = first;
    if (first) {
        if (!copies_equal(board)) {
            write_copy(settings, board, COPY[1]);
        }
    } else if (read_copy(settings, board, COPY[1], WB_SETTINGS_VERSION, WB_SETTINGS_COUNT)) {
        settings->good = true;
        write_copy(settings, board, COPY[0]);
    } else if (read_copy(settings, board, OLD_COPY, OLD_VERSION, OLD_COUNT)) {
        settings->good = true;
        store(settings, board);
    }
}

bool wb_settings_change(struct wb_settings *settings, void *board, int32_t id, int32_t value, bool *known)
{
    *known = id >= 1 && id <= WB_SETTINGS_COUNT;
    if (!*known || !allowed((uint8_t)(id - 1), value)) {
        return false;
    }
    int32_t before = settings->value[id - 1];
    settings->value[id - 1] = value;
    if (!consistent(settings)) {
        settings->value[id - 1] = before;
        return false;
    }
    store(settings, board);
    return true;
}

void wb_settings_defaults(struct wb_settings *settings, void *board)
{
    for (uint8_t i = 0; i < WB_SETTINGS_COUNT; i++) {
        settings->value[i] = DEFAULTS[i];
    }
    store(settings, board);
    settings->good = true;
}
