/* Runs the inputs of a fuzzer without the fuzzer: every file that is named, and random mixtures of their lines.
 *
 *   replay 2000 seeds/... */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Bytes of a seed. */
#define SEED_MAX 65536
#define SEEDS_MAX 64
/* Bytes of a mixture. */
#define MIXED_MAX 2048

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static struct {
    uint8_t *bytes;
    size_t size; /* bytes */
} seed[SEEDS_MAX];

/* Xorshift of Marsaglia (Xorshift RNGs, 2003): the same numbers every time. */
static uint32_t chance(uint32_t below)
{
    static uint32_t state = 2463534242u;
    state ^= state << 13;
    state ^= state >> 17;
    state ^= state << 5;
    return state % below;
}

/* Pieces of the seeds one after the other, some bytes of them changed. Gives the size. */
static size_t mix(uint8_t *mixed, int seeds)
{
    size_t size = 0;
    for (uint32_t pieces = 1 + chance(12); pieces > 0; pieces--) {
        uint32_t from = chance((uint32_t)seeds);
        if (seed[from].size == 0) {
            continue;
        }
        size_t begin = chance((uint32_t)seed[from].size);
        while (begin > 0 && seed[from].bytes[begin - 1] != '\n') {
            begin--;
        }
        size_t length = 1 + chance(120);
        if (length > seed[from].size - begin) {
            length = seed[from].size - begin;
        }
        if (size + length + 1 > MIXED_MAX) {
            break;
        }
        memcpy(mixed + size, seed[from].bytes + begin, length);
        size += length;
        mixed[size++] = '\n';
    }
    for (uint32_t changes = chance(6); changes > 0 && size > 0; changes--) {
        mixed[chance((uint32_t)size)] = (uint8_t)chance(chance(2) ? 256 : 128);
    }
    return size;
}

int main(int count, char **argument)
{
    static uint8_t mixed[MIXED_MAX];
    int seeds = count - 2;
    if (seeds < 1 || seeds > SEEDS_MAX) {
        fprintf(stderr, "replay MIXTURES FILE...: 1 to %d files\n", SEEDS_MAX);
        return 2;
    }
    for (int i = 0; i < seeds; i++) {
        FILE *file = fopen(argument[i + 2], "rb");
        seed[i].bytes = malloc(SEED_MAX);
        if (!file || !seed[i].bytes) {
            fprintf(stderr, "%s cannot be read\n", argument[i + 2]);
            return 2;
        }
        seed[i].size = fread(seed[i].bytes, 1, SEED_MAX, file);
        fclose(file);
        LLVMFuzzerTestOneInput(seed[i].bytes, seed[i].size);
    }
    long mixtures = strtol(argument[1], NULL, 10);
    for (long i = 0; i < mixtures; i++) {
        LLVMFuzzerTestOneInput(mixed, mix(mixed, seeds));
    }
    printf("%d inputs and %ld mixtures of them\n", seeds, mixtures);
    return 0;
}
