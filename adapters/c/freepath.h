/* Turns a sampler in C (C99 or later) into a subject of freepath. One header, no dependency but the C library (-lm):
 *
 *     #include "freepath.h"
 *     static double tracker(const freepath_medium *medium, freepath_rng *rng) { .. }   // infinity for an escape
 *     int main(void) { return freepath_serve(tracker, NULL, NULL); }
 *
 * `freepath run --allow-commands` starts the program, tells it on standard input what to draw and reads doubles from
 * standard output. So print to standard error, take every random number from `rng`, and nothing from the clock.
 *
 * freepath_mu knows every medium but `formula`; of that medium->request has the JSON.
 */
#ifndef FREEPATH_ADAPTER_H
#define FREEPATH_ADAPTER_H

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Random numbers: splitmix64 (Steele, Lea and Flood 2014). */
typedef struct freepath_rng {
    uint64_t state;
} freepath_rng;

static inline uint64_t freepath_bits(freepath_rng *rng) {
    uint64_t z = (rng->state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/* Uniform in [0, 1), of 53 bits. */
static inline double freepath_uniform(freepath_rng *rng) {
    return (double)(freepath_bits(rng) >> 11) * 0x1p-53;
}

/* The extinction along the ray. */
typedef struct freepath_medium {
    double length;
    /* In segment k, up to ends[k], mu is at most mu_bar[k]. */
    size_t segments;
    double *ends, *mu_bar;
    /* The request as it came, for media and fields that this header does not know. */
    const char *request;
    /* Read through freepath_mu. */
    int kind;
    double base, peak, center, width, mu0, scale_height, mean, amplitude, per_length, phase;
    /* Of a medium in media: mu(t) = by * mu_within(start + slope * t). */
    double by, start, slope;
    size_t cells, rows_per_cell;
    double *t, *mu;
    /* Of a chromatic medium: extinction and scattering of each channel. */
    size_t channels;
    double *sigma_t, *sigma_s;
} freepath_medium;

enum { FREEPATH_TABLE = 1, FREEPATH_GAUSSIAN, FREEPATH_EXPONENTIAL, FREEPATH_SINUSOID };

static inline void freepath_die(const char *what, const char *which) {
    fprintf(stderr, "freepath.h: %s %s\n", what, which);
    exit(2);
}

/* The extinction of a medium that is no table. */
static inline double freepath_curve(const freepath_medium *medium, double t) {
    double x = (t - medium->center) / medium->width;
    switch (medium->kind) {
        case FREEPATH_GAUSSIAN: return medium->base + medium->peak * exp(-0.5 * x * x);
        case FREEPATH_EXPONENTIAL: return medium->mu0 * exp(-t / medium->scale_height);
        case FREEPATH_SINUSOID: return medium->mean * (1.0 + medium->amplitude * sin(medium->per_length * t + medium->phase));
    }
    freepath_die("this header does not know mu(t) of the medium; write it yourself:", medium->request);
    return 0.0;
}

/* Extinction at t, 1/length. */
static inline double freepath_mu(const freepath_medium *medium, double t) {
    if (medium->kind != FREEPATH_TABLE) return medium->by * freepath_curve(medium, medium->start + medium->slope * t);
    size_t n = medium->rows_per_cell, low = 0, high = medium->cells; /* t is in cell low, before cell high */
    while (high - low > 1) {
        size_t middle = low + (high - low) / 2;
        if (medium->t[middle * n] <= t) low = middle; else high = middle;
    }
    const double *at = medium->t + low * n, *mu = medium->mu + low * n;
    double u = (t - at[0]) / (at[n - 1] - at[0]) * (double)(n - 1), sum = 0.0;
    for (size_t k = 0; k < n; k++) { /* Lagrange's polynomial through the nodes of the cell */
        double weight = 1.0;
        for (size_t j = 0; j < n; j++)
            if (j != k) weight *= (u - (double)j) / ((double)k - (double)j);
        sum += weight * mu[k];
    }
    return sum;
}

static inline void *freepath_room(size_t numbers) {
    void *room = malloc((numbers ? numbers : 1) * sizeof(double));
    if (!room) freepath_die("out of", "memory");
    return room;
}

/* What follows "key": in the JSON text `from`, or NULL. Keys inside strings are not looked for: the protocol has none. */
static inline const char *freepath_find(const char *from, const char *key) {
    size_t n = strlen(key);
    int inside = 0;
    for (const char *p = from; *p; p++) {
        if (inside && *p == '\\') { if (*++p) continue; else break; }
        if (*p != '"') continue;
        inside = !inside;
        if (inside && strncmp(p + 1, key, n) == 0 && p[n + 1] == '"') {
            const char *after = p + n + 2 + strspn(p + n + 2, " \t");
            if (*after == ':') return after + 1 + strspn(after + 1, " \t");
        }
    }
    return NULL;
}

static inline double freepath_number(const char *from, const char *key, int needed, double otherwise) {
    const char *at = from ? freepath_find(from, key) : NULL;
    if (!at && needed) freepath_die("the request has no number", key);
    return at ? strtod(at, NULL) : otherwise;
}

/* The string after "key", in memory of its own; NULL if there is none. Escapes but \u, which ASCII names do not need. */
static inline char *freepath_string(const char *from, const char *key) {
    const char *at = freepath_find(from, key);
    if (!at || *at != '"') return NULL;
    char *text = (char *)malloc(strlen(at)), *to = text;
    if (!text) freepath_die("out of", "memory");
    for (at++; *at && *at != '"'; at++) {
        if (*at == '\\' && at[1]) at++;
        *to++ = *at;
    }
    *to = '\0';
    return text;
}

/* One line of standard input. */
static inline char *freepath_line(void) {
    size_t room = 4096, used = 0;
    char *line = (char *)malloc(room);
    int c;
    while (line && (c = getchar()) != EOF && c != '\n') {
        line[used++] = (char)c;
        if (used == room) line = (char *)realloc(line, room *= 2);
    }
    if (!line) freepath_die("out of", "memory");
    line[used] = '\0';
    return line;
}

static inline void freepath_read_majorants(freepath_medium *medium) {
    const char *at = freepath_find(medium->request, "majorants");
    const char *end = at ? strchr(at, ']') : NULL;
    size_t n = 0;
    if (!end) freepath_die("the request has no", "majorants");
    for (const char *p = at; p < end; p++) n += *p == '{';
    medium->segments = n;
    medium->ends = (double *)freepath_room(n);
    medium->mu_bar = (double *)freepath_room(n);
    for (size_t k = 0; k < n; k++) {
        at = strchr(at, '{') + 1;
        medium->ends[k] = freepath_number(at, "end", 1, 0.0);
        medium->mu_bar[k] = freepath_number(at, "mu_bar", 1, 0.0);
    }
}

static inline void freepath_read_table(freepath_medium *medium, const char *path) {
    FILE *file = fopen(path, "r");
    size_t room = 1024, used = 0;
    double t, mu;
    if (!file || fscanf(file, "t,mu ") != 0) freepath_die("cannot read", path);
    medium->t = (double *)freepath_room(room);
    medium->mu = (double *)freepath_room(room);
    while (fscanf(file, "%lf,%lf ", &t, &mu) == 2) {
        if (used == room) {
            room *= 2;
            medium->t = (double *)realloc(medium->t, room * sizeof(double));
            medium->mu = (double *)realloc(medium->mu, room * sizeof(double));
            if (!medium->t || !medium->mu) freepath_die("out of", "memory");
        }
        medium->t[used] = t;
        medium->mu[used++] = mu;
    }
    fclose(file);
    medium->rows_per_cell = (size_t)freepath_number(medium->request, "rows_per_cell", 1, 0.0);
    medium->cells = medium->rows_per_cell ? used / medium->rows_per_cell : 0;
    medium->kind = FREEPATH_TABLE;
    if (medium->cells == 0) freepath_die("no rows in", path);
}

/* Whether the object at `at` has this as its first key: what kind of medium it is. */
static inline int freepath_is(const char *at, const char *kind) {
    size_t n = strlen(kind);
    const char *key = *at == '{' ? at + 1 + strspn(at + 1, " \t") : "";
    return *key == '"' && strncmp(key + 1, kind, n) == 0 && key[n + 1] == '"';
}

/* The length of the medium at `at`. Media state their numbers before the medium within. */
static inline double freepath_length(const char *at) {
    while (freepath_is(at, "scaled") || freepath_is(at, "reversed")) {
        at = freepath_find(at, "medium");
        if (!at) freepath_die("the request has no", "medium within a medium");
    }
    if (!freepath_is(at, "segment")) return freepath_number(at, "length", 1, 0.0);
    return freepath_number(at, "to", 1, 0.0) - freepath_number(at, "from", 1, 0.0);
}

/* The innermost medium in the one at `at`; where it lies is kept. */
static inline const char *freepath_within(freepath_medium *medium, const char *at) {
    medium->by = medium->slope = 1.0;
    for (;;) {
        if (freepath_is(at, "scaled")) {
            medium->by *= freepath_number(at, "by", 1, 0.0);
        } else if (freepath_is(at, "segment")) {
            medium->start += freepath_number(at, "from", 1, 0.0);
        } else if (freepath_is(at, "reversed")) {
            medium->start = freepath_length(at) - medium->start;
            medium->slope = -medium->slope;
        } else {
            return at;
        }
        at = freepath_find(at, "medium");
        if (!at) freepath_die("the request has no", "medium within a medium");
    }
}

/* The numbers of the list after "key": in `from`, times `by`; how many there are. */
static inline size_t freepath_list(const char *from, const char *key, double by, double **list) {
    const char *at = freepath_find(from, key);
    char *end;
    size_t n = 0;
    if (!at || *at != '[') freepath_die("the request has no list", key);
    *list = (double *)freepath_room(strlen(at) / 2);
    for (at++; *at != ']'; at = end + strspn(end, ", \t"), n++) {
        (*list)[n] = by * strtod(at, &end);
        if (end == at) freepath_die("the request has no list", key);
    }
    return n;
}

static inline void freepath_read_curve(freepath_medium *medium, const char *outer) {
    const char *is = freepath_within(medium, outer);
    if (freepath_is(is, "chromatic")) {
        medium->channels = freepath_list(is, "sigma_t", medium->by, &medium->sigma_t);
        freepath_list(is, "sigma_s", medium->by, &medium->sigma_s);
    } else if (freepath_is(is, "gaussian")) {
        const char *close = strchr(is, '}');
        const char *base = freepath_find(is, "base");
        medium->kind = FREEPATH_GAUSSIAN;
        medium->base = base && base < close ? strtod(base, NULL) : 0.0;
        medium->peak = freepath_number(is, "peak", 1, 0.0);
        medium->center = freepath_number(is, "center", 1, 0.0);
        medium->width = freepath_number(is, "width", 1, 0.0);
    } else if (freepath_is(is, "exponential")) {
        medium->kind = FREEPATH_EXPONENTIAL;
        medium->mu0 = freepath_number(is, "mu0", 1, 0.0);
        medium->scale_height = freepath_number(is, "scale_height", 1, 0.0);
    } else if (freepath_is(is, "sinusoid")) {
        medium->kind = FREEPATH_SINUSOID;
        medium->mean = freepath_number(is, "mean", 1, 0.0);
        medium->amplitude = freepath_number(is, "amplitude", 1, 0.0);
        medium->per_length = 2.0 * acos(-1.0) * freepath_number(is, "frequency", 1, 0.0);
        medium->phase = freepath_number(is, "phase", 0, 0.0);
    }
}

static inline void freepath_read_medium(freepath_medium *medium) {
    const char *outer = freepath_find(medium->request, "medium");
    const char *after = strstr(medium->request, "\"majorants\"");
    if (!outer || !after) freepath_die("the request has no", "medium");
    char *table = freepath_string(after, "table"); /* a medium is called so, too */
    medium->length = freepath_number(after, "length", 1, 0.0);
    if (table) {
        freepath_read_table(medium, table);
        free(table);
    } else {
        freepath_read_curve(medium, outer);
    }
}

/* A free path (infinity for an escape), or an estimate of the transmittance. */
typedef double (*freepath_sampler)(const freepath_medium *medium, freepath_rng *rng);

enum { FREEPATH_SCATTER = 0, FREEPATH_SURFACE = 1 };

/* A chromatic draw: returns the event, writes its distance to t and as many weights as the medium has channels. */
typedef int (*freepath_chromatic)(const freepath_medium *medium, freepath_rng *rng, double *t, double *weights);

static inline void freepath_write(double x) {
    uint64_t bits;
    unsigned char bytes[8];
    memcpy(&bits, &x, 8);
    for (int i = 0; i < 8; i++) bytes[i] = (unsigned char)(bits >> (8 * i));
    if (fwrite(bytes, 1, 8, stdout) != 8) freepath_die("cannot write", "a draw");
}

static inline void freepath_draw(const freepath_medium *medium, uint64_t draws, uint64_t seed, freepath_sampler sampler) {
    freepath_rng rng = {seed};
    for (uint64_t i = 0; i < draws; i++) freepath_write(sampler(medium, &rng));
}

static inline void freepath_draw_chromatic(const freepath_medium *medium, uint64_t draws, uint64_t seed, freepath_chromatic sampler) {
    freepath_rng rng = {seed};
    double t = 0.0, *weights = (double *)freepath_room(medium->channels);
    for (uint64_t i = 0; i < draws; i++) {
        int event = sampler(medium, &rng, &t, weights);
        freepath_write(t);
        freepath_write((double)event);
        for (size_t c = 0; c < medium->channels; c++) freepath_write(weights[c]);
    }
    free(weights);
}

/* Answers one request by the sampler of its kind; any of them may be NULL. */
static inline int freepath_serve(freepath_sampler free_path, freepath_sampler transmittance, freepath_chromatic chromatic) {
    freepath_medium medium;
    char *line = freepath_line(), *kind;
    memset(&medium, 0, sizeof medium);
    medium.request = line;
    if (freepath_number(line, "protocol", 1, 0.0) != 1.0) freepath_die("unknown", "protocol");
    kind = freepath_string(line, "kind");
    int is_chromatic = kind && strcmp(kind, "chromatic") == 0;
    freepath_sampler sampler = NULL;
    if (kind && strcmp(kind, "free_path") == 0) sampler = free_path;
    if (kind && strcmp(kind, "transmittance") == 0) sampler = transmittance;
    if (is_chromatic ? !chromatic : !sampler) freepath_die("there is no sampler of the kind", kind ? kind : "?");
    freepath_read_majorants(&medium);
    freepath_read_medium(&medium);
    uint64_t seed = (uint64_t)freepath_number(line, "seed", 1, 0.0), draws = (uint64_t)freepath_number(line, "draws", 1, 0.0);
    if (is_chromatic) freepath_draw_chromatic(&medium, draws, seed, chromatic);
    else freepath_draw(&medium, draws, seed, sampler);
    if (fflush(stdout) != 0) freepath_die("cannot write", "the draws");
    free(medium.ends), free(medium.mu_bar), free(medium.t), free(medium.mu), free(medium.sigma_t), free(medium.sigma_s);
    free(kind), free(line);
    return 0;
}

#endif
