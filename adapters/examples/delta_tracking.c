/* Delta tracking, and a chromatic sampler. With the argument `late` the one looks mu up a step late, and the weights of the
 * other are too large: wrong samplers. */
#include "../c/freepath.h"

static double late = 0.0;

static double delta_tracking(const freepath_medium *medium, freepath_rng *rng) {
    double t = 0.0, mu_bar = medium->mu_bar[0];
    for (size_t k = 1; k < medium->segments; k++)
        if (medium->mu_bar[k] > mu_bar) mu_bar = medium->mu_bar[k];
    for (;;) {
        t -= log(1.0 - freepath_uniform(rng)) / mu_bar;
        if (t >= medium->length) return INFINITY;
        double look_up = t + late < medium->length ? t + late : medium->length;
        if (freepath_uniform(rng) * mu_bar < freepath_mu(medium, look_up)) return t;
    }
}

/* 1 if the walk escapes, else 0. */
static double escapes(const freepath_medium *medium, freepath_rng *rng) {
    return isinf(delta_tracking(medium, rng)) ? 1.0 : 0.0;
}

/* A channel is drawn, and its distance weighted by the mean density of all (the balance heuristic). */
static int one_channel(const freepath_medium *medium, freepath_rng *rng, double *t, double *weights) {
    double sigma = medium->sigma_t[(size_t)(freepath_uniform(rng) * (double)medium->channels)], density = 0.0;
    *t = -log(1.0 - freepath_uniform(rng)) / sigma;
    int event = *t < medium->length ? FREEPATH_SCATTER : FREEPATH_SURFACE;
    if (event == FREEPATH_SURFACE) *t = medium->length;
    for (size_t c = 0; c < medium->channels; c++) {
        double beam = exp(-medium->sigma_t[c] * *t);
        density += beam * (event == FREEPATH_SURFACE ? 1.0 : medium->sigma_t[c]) / (double)medium->channels;
        weights[c] = beam * (event == FREEPATH_SURFACE ? 1.0 : medium->sigma_s[c]);
    }
    for (size_t c = 0; c < medium->channels; c++) weights[c] *= (late > 0.0 ? 1.05 : 1.0) / density;
    return event;
}

int main(int argc, char **argv) {
    if (argc > 1 && strcmp(argv[1], "late") == 0) late = 0.1;
    return freepath_serve(delta_tracking, escapes, one_channel);
}
