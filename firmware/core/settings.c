#include "settings.h"

#include "crc.h"
#include "flash.h"
#include "hal.h"

/* Where things are stored. */
#define BOOTS 0
#define VERSION 2
#define MACHINE 3
#define VALUES 4
#define SUM (VALUES + 4 * WB_SETTINGS_COUNT)

static const WB_FLASH struct { int32_t least, most; } RANGE[WB_SETTINGS_COUNT] = {WB_SETTINGS_RANGES};
static const WB_FLASH int32_t DEFAULTS[WB_SETTINGS_COUNT] = {WB_MACHINE_DEFAULTS};

int32_t wb_setting(const struct wb_settings *settings, uint8_t id)
{
    return settings->value[id - 1];
}

static bool allowed(uint8_t index, int32_t value)
{
    return value >= RANGE[index].least && value <= RANGE[index].most;
}

/* What every move relies on beyond the range of each. */
static bool consistent(const struct wb_settings *settings)
{
    int32_t home = wb_setting(settings, WB_SETTING_HOME_POSITION);
    int32_t limit = wb_setting(settings, WB_SETTING_BEND_LIMIT);
    return (home < 0 ? -home : home) >= limit && wb_setting(settings, WB_SETTING_NEAR_SIDE) <= limit &&
           wb_setting(settings, WB_SETTING_HOME_BACK_OFF) <= wb_setting(settings, WB_SETTING_HOME_TRAVEL);
}

void wb_settings_load(struct wb_settings *settings, void *board)
{
    uint16_t crc = WB_SETTINGS_VERSION;
    for (uint16_t at = VERSION; at < SUM; at++) {
        crc = wb_crc16(crc, hal_stored(board, at));
    }
    uint16_t told = (uint16_t)(hal_stored(board, SUM) | hal_stored(board, SUM + 1) << 8);
    settings->good = crc == told && hal_stored(board, VERSION) == WB_SETTINGS_VERSION &&
                     hal_stored(board, MACHINE) == WB_MACHINE_ID;
    for (uint8_t i = 0; i < WB_SETTINGS_COUNT; i++) {
        uint32_t value = 0;
        for (uint8_t k = 4; k > 0; k--) {
            value = value << 8 | hal_stored(board, (uint16_t)(VALUES + 4 * i + k - 1));
        }
        settings->value[i] = (int32_t)value;
        settings->good = settings->good && allowed(i, settings->value[i]);
    }
    settings->good = settings->good && consistent(settings);
}

static void store(const struct wb_settings *settings, void *board)
{
    uint16_t crc = WB_SETTINGS_VERSION;
    for (uint16_t at = VERSION; at < SUM; at++) {
        uint8_t byte;
        if (at == VERSION) {
            byte = WB_SETTINGS_VERSION;
        } else if (at == MACHINE) {
            byte = WB_MACHINE_ID;
        } else {
            uint16_t offset = (uint16_t)(at - VALUES);
            byte = (uint8_t)((uint32_t)settings->value[offset / 4] >> (8 * (offset % 4)));
        }
        crc = wb_crc16(crc, byte);
        hal_store(board, at, byte);
    }
    hal_store(board, SUM, (uint8_t)crc);
    hal_store(board, SUM + 1, (uint8_t)(crc >> 8));
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

uint16_t wb_settings_boots(void *board)
{
    uint16_t boots = (uint16_t)(hal_stored(board, BOOTS) | hal_stored(board, BOOTS + 1) << 8);
    boots = (uint16_t)(boots + 1);
    hal_store(board, BOOTS, (uint8_t)boots);
    hal_store(board, BOOTS + 1, (uint8_t)(boots >> 8));
    return boots;
}
