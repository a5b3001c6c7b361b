/* Delta tracking. With the argument `late` it looks mu up a step late: a wrong sampler. */
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

int main(int argc, char **argv) {
    if (argc > 1 && strcmp(argv[1], "late") == 0) late = 0.1;
    return freepath_serve(delta_tracking, escapes);
}
