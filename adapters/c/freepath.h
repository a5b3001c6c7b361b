/* Turns a sampler in C (C99 or later) into a subject of freepath. One header, no dependency but the C library (-lm):
 *
 *     #include "freepath.h"
 *     static double tracker(const freepath_medium *medium, freepath_rng *rng) { .. }   // infinity for an escape
 *     int main(void) { return freepath_serve(tracker, NULL); }
 *
 * `freepath run --allow-commands` starts the program, tells it on standard input what to draw and reads doubles from
 * standard output. So print to standard error, take every random number from `rng`, and nothing from the clock.
 *
 * Known media: gaussian, exponential, and all that come as a table (constant, linear, piecewise, voxels and the like).
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
    double base, peak, center, width, mu0, scale_height;
    size_t cells, rows_per_cell;
    double *t, *mu;
} freepath_medium;

enum { FREEPATH_TABLE = 1, FREEPATH_GAUSSIAN, FREEPATH_EXPONENTIAL };

/* Extinction at t, 1/length. */
static inline double freepath_mu(const freepath_medium *medium, double t) {
    if (medium->kind == FREEPATH_GAUSSIAN) {
        double x = (t - medium->center) / medium->width;
        return medium->base + medium->peak * exp(-0.5 * x * x);
    }
    if (medium->kind == FREEPATH_EXPONENTIAL) return medium->mu0 * exp(-t / medium->scale_height);
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

static inline void freepath_die(const char *what, const char *which) {
    fprintf(stderr, "freepath.h: %s %s\n", what, which);
    exit(2);
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

static inline void freepath_read_medium(freepath_medium *medium) {
    const char *outer = freepath_find(medium->request, "medium");
    const char *after = strstr(medium->request, "\"majorants\"");
    char *table = after ? freepath_string(after, "table") : NULL; /* a medium is called so, too */
    const char *is = outer && *outer == '{' ? outer + 1 + strspn(outer + 1, " \t") : "";
    medium->length = freepath_number(after, "length", 1, 0.0);
    if (table) {
        freepath_read_table(medium, table);
        free(table);
    } else if (strncmp(is, "\"gaussian\"", 10) == 0) {
        const char *close = strchr(is, '}');
        const char *base = freepath_find(is, "base");
        medium->kind = FREEPATH_GAUSSIAN;
        medium->base = base && base < close ? strtod(base, NULL) : 0.0;
        medium->peak = freepath_number(is, "peak", 1, 0.0);
        medium->center = freepath_number(is, "center", 1, 0.0);
        medium->width = freepath_number(is, "width", 1, 0.0);
    } else if (strncmp(is, "\"exponential\"", 13) == 0) {
        medium->kind = FREEPATH_EXPONENTIAL;
        medium->mu0 = freepath_number(is, "mu0", 1, 0.0);
        medium->scale_height = freepath_number(is, "scale_height", 1, 0.0);
    } else {
        freepath_die("this header does not know mu(t) of the medium; write it yourself:", outer ? outer : "");
    }
}

typedef double (*freepath_sampler)(const freepath_medium *medium, freepath_rng *rng);

static inline void freepath_write(double x) {
    uint64_t bits;
    unsigned char bytes[8];
    memcpy(&bits, &x, 8);
    for (int i = 0; i < 8; i++) bytes[i] = (unsigned char)(bits >> (8 * i));
    if (fwrite(bytes, 1, 8, stdout) != 8) freepath_die("cannot write", "a draw");
}

/* Answers one request: free_path gives t, infinity for an escape; transmittance gives an estimate. Either may be NULL. */
static inline int freepath_serve(freepath_sampler free_path, freepath_sampler transmittance) {
    freepath_medium medium;
    freepath_rng rng;
    char *line = freepath_line(), *kind;
    memset(&medium, 0, sizeof medium);
    medium.request = line;
    if (freepath_number(line, "protocol", 1, 0.0) != 1.0) freepath_die("unknown", "protocol");
    kind = freepath_string(line, "kind");
    freepath_sampler sampler = NULL;
    if (kind && strcmp(kind, "free_path") == 0) sampler = free_path;
    if (kind && strcmp(kind, "transmittance") == 0) sampler = transmittance;
    if (!sampler) freepath_die("there is no sampler of the kind", kind ? kind : "?");
    freepath_read_majorants(&medium);
    freepath_read_medium(&medium);
    rng.state = (uint64_t)freepath_number(line, "seed", 1, 0.0);
    uint64_t draws = (uint64_t)freepath_number(line, "draws", 1, 0.0);
    for (uint64_t i = 0; i < draws; i++) freepath_write(sampler(&medium, &rng));
    if (fflush(stdout) != 0) freepath_die("cannot write", "the draws");
    free(medium.ends), free(medium.mu_bar), free(medium.t), free(medium.mu), free(kind), free(line);
    return 0;
}

#endif
