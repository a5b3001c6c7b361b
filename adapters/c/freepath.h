/* Turns a sampler in C (C99 or later) into a subject of freepath. One header, no dependency but the C library (-lm):
 *
 *     #include "freepath.h"
 *     static double tracker(const freepath_medium *medium, freepath_rng *rng) { .. }   // infinity for an escape
 *     int main(void) { return freepath_serve(tracker, NULL, NULL); }
 *
 * For a kind whose scene has no ray, such as `density` or `direction`, a sampler writes a row:
 *
 *     static void ramp(const freepath_medium *scene, freepath_rng *rng, double *row) { row[0] = 2.0 * sqrt(freepath_uniform(rng)); }
 *     int main(void) { freepath_kind kinds[] = {{"density", ramp}}; return freepath_serve_rows(kinds, 1); }
 *
 * `freepath run --allow-commands` starts the program, tells it on standard input what to draw and reads doubles from
 * standard output. So print to standard error, take every random number from `rng`, and nothing from the clock.
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
    /* The request as it came, with the medium as the case has it. */
    const char *request;
    /* Read through freepath_mu. */
    size_t cells, rows_per_cell;
    double *t, *terms;
    /* Of a chromatic medium: extinction and scattering of each channel. */
    size_t channels;
    double *sigma_t, *sigma_s;
} freepath_medium;

static inline void freepath_die(const char *what, const char *which) {
    fprintf(stderr, "freepath.h: %s %s\n", what, which);
    exit(2);
}

/* Extinction at t, 0 <= t <= length, in 1/length. A chromatic medium has that of its channels instead. */
static inline double freepath_mu(const freepath_medium *medium, double t) {
    if (medium->cells == 0) freepath_die("channels and scenes without a ray have", "no mu(t)");
    size_t n = medium->rows_per_cell, low = 0, high = medium->cells; /* t is in cell low, before cell high */
    while (high - low > 1) {
        size_t middle = low + (high - low) / 2;
        if (medium->t[middle * n] <= t) low = middle; else high = middle;
    }
    const double *at = medium->t + low * n, *terms = medium->terms + low * n;
    double s = (t - at[0]) / (at[n - 1] - at[0]) * (double)(n - 1), sum = 0.0;
    for (size_t k = n; k-- > 0;) sum = sum * (s - (double)k) + terms[k];
    return sum < 0.0 ? 0.0 : sum; /* by rounding */
}

/* Of the polynomial through the n rows of a cell: Newton's forward differences over their factorials. */
static inline void freepath_differences(double *mu, size_t n) {
    for (size_t order = 1; order < n; order++)
        for (size_t k = n - 1; k >= order; k--) mu[k] = (mu[k] - mu[k - 1]) / (double)order;
}

static inline void *freepath_room(size_t numbers) {
    void *room = malloc((numbers ? numbers : 1) * sizeof(double));
    if (!room) freepath_die("out of", "memory");
    return room;
}

/* What follows "key": in the JSON object at `object`, not in objects within; or NULL. */
static inline const char *freepath_find(const char *object, const char *key) {
    size_t n = strlen(key);
    int inside = 0, depth = 0;
    for (const char *p = object; *p; p++) {
        if (inside && *p == '\\') { if (*++p) continue; else break; }
        if (!inside && (*p == '{' || *p == '[')) depth++;
        if (!inside && (*p == '}' || *p == ']') && --depth == 0) break;
        if (*p != '"') continue;
        inside = !inside;
        if (inside && depth == 1 && strncmp(p + 1, key, n) == 0 && p[n + 1] == '"') {
            const char *after = p + n + 2 + strspn(p + n + 2, " \t");
            if (*after == ':') return after + 1 + strspn(after + 1, " \t");
        }
    }
    return NULL;
}

static inline double freepath_number(const char *object, const char *key) {
    const char *at = freepath_find(object, key);
    if (!at) freepath_die("the request has no number", key);
    return strtod(at, NULL);
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
        at = strchr(at + 1, '{');
        medium->ends[k] = freepath_number(at, "end");
        medium->mu_bar[k] = freepath_number(at, "mu_bar");
    }
}

static inline void freepath_read_table(freepath_medium *medium) {
    char *path = freepath_string(medium->request, "table");
    if (!path) freepath_die("the request has neither channels nor a", "table");
    FILE *file = fopen(path, "r");
    size_t room = 1024, used = 0;
    double t, mu;
    if (!file || fscanf(file, "t,mu ") != 0) freepath_die("cannot read", path);
    medium->t = (double *)freepath_room(room);
    medium->terms = (double *)freepath_room(room);
    while (fscanf(file, "%lf,%lf ", &t, &mu) == 2) {
        if (used == room) {
            room *= 2;
            medium->t = (double *)realloc(medium->t, room * sizeof(double));
            medium->terms = (double *)realloc(medium->terms, room * sizeof(double));
            if (!medium->t || !medium->terms) freepath_die("out of", "memory");
        }
        medium->t[used] = t;
        medium->terms[used++] = mu;
    }
    fclose(file);
    size_t n = medium->rows_per_cell = (size_t)freepath_number(medium->request, "rows_per_cell");
    medium->cells = n < 2 ? 0 : used / n;
    if (medium->cells == 0) freepath_die("no rows in", path);
    for (size_t cell = 0; cell < medium->cells; cell++) freepath_differences(medium->terms + cell * n, n);
    free(path);
}

/* The numbers of the list after "key"; how many there are, none without such a list. */
static inline size_t freepath_list(const char *object, const char *key, double **list) {
    const char *at = freepath_find(object, key);
    char *end;
    size_t n = 0;
    if (!at) return 0;
    *list = (double *)freepath_room(strlen(at) / 2);
    for (at += strspn(at, "[ "); *at != ']'; at = end + strspn(end, ", \t"), n++) {
        (*list)[n] = strtod(at, &end);
        if (end == at) freepath_die("the request has no list", key);
    }
    return n;
}

static inline void freepath_read_medium(freepath_medium *medium) {
    medium->length = freepath_number(medium->request, "length");
    medium->channels = freepath_list(medium->request, "sigma_t", &medium->sigma_t);
    if (freepath_list(medium->request, "sigma_s", &medium->sigma_s) != medium->channels)
        freepath_die("the request has not as many sigma_s as", "sigma_t");
    if (medium->channels == 0) freepath_read_table(medium);
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

/* A row of a kind: as many numbers as it has columns, of `direction` x, y, z, of `table_2d` x, y, of `density` one. */
typedef void (*freepath_row)(const freepath_medium *scene, freepath_rng *rng, double *row);

/* A kind by its name, and who draws its rows. */
typedef struct freepath_kind {
    const char *name;
    freepath_row sampler;
} freepath_kind;

/* Names in the list of strings after "key". */
static inline size_t freepath_strings(const char *object, const char *key) {
    const char *at = freepath_find(object, key);
    size_t quotes = 0;
    if (!at || *at != '[') freepath_die("the request has no list", key);
    for (; *at && *at != ']'; at++) quotes += *at == '"';
    return quotes / 2;
}

static inline void freepath_draw_rows(const freepath_medium *scene, freepath_row sampler) {
    size_t columns = freepath_strings(scene->request, "columns");
    uint64_t draws = (uint64_t)freepath_number(scene->request, "draws");
    freepath_rng rng = {(uint64_t)freepath_number(scene->request, "seed")};
    double *row = (double *)freepath_room(columns);
    for (uint64_t i = 0; i < draws; i++) {
        sampler(scene, &rng, row);
        for (size_t k = 0; k < columns; k++) freepath_write(row[k]);
    }
    free(row);
    if (fflush(stdout) != 0) freepath_die("cannot write", "the draws");
}

/* Answers one request by the sampler of its kind, in a scene without a ray: parameters are read from `scene->request` by
 * freepath_find, freepath_number and freepath_list. */
static inline int freepath_serve_rows(const freepath_kind *kinds, size_t count) {
    freepath_medium scene;
    char *line = freepath_line(), *kind;
    freepath_row sampler = NULL;
    memset(&scene, 0, sizeof scene);
    scene.request = line;
    if (freepath_number(line, "protocol") != 1.0) freepath_die("unknown", "protocol");
    kind = freepath_string(line, "kind");
    for (size_t i = 0; i < count; i++)
        if (kind && strcmp(kind, kinds[i].name) == 0) sampler = kinds[i].sampler;
    if (!sampler) freepath_die("there is no sampler of the kind", kind ? kind : "?");
    freepath_draw_rows(&scene, sampler);
    free(kind), free(line);
    return 0;
}

/* Answers one request by the sampler of its kind; any of them may be NULL. */
static inline int freepath_serve(freepath_sampler free_path, freepath_sampler transmittance, freepath_chromatic chromatic) {
    freepath_medium medium;
    char *line = freepath_line(), *kind;
    memset(&medium, 0, sizeof medium);
    medium.request = line;
    if (freepath_number(line, "protocol") != 1.0) freepath_die("unknown", "protocol");
    kind = freepath_string(line, "kind");
    int is_chromatic = kind && strcmp(kind, "chromatic") == 0;
    freepath_sampler sampler = NULL;
    if (kind && strcmp(kind, "free_path") == 0) sampler = free_path;
    if (kind && strcmp(kind, "transmittance") == 0) sampler = transmittance;
    if (is_chromatic ? !chromatic : !sampler) freepath_die("there is no sampler of the kind", kind ? kind : "?");
    freepath_read_majorants(&medium);
    freepath_read_medium(&medium);
    uint64_t seed = (uint64_t)freepath_number(line, "seed"), draws = (uint64_t)freepath_number(line, "draws");
    if (is_chromatic) freepath_draw_chromatic(&medium, draws, seed, chromatic);
    else freepath_draw(&medium, draws, seed, sampler);
    if (fflush(stdout) != 0) freepath_die("cannot write", "the draws");
    free(medium.ends), free(medium.mu_bar), free(medium.t), free(medium.terms), free(medium.sigma_t), free(medium.sigma_s);
    free(kind), free(line);
    return 0;
}

#endif
