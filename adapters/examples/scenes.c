/* Samplers in scenes without a ray. With the argument `wrong` the uniform that all begin with is a little too small. */
#include "../c/freepath.h"

static double shrink = 1.0;

static double first(freepath_rng *rng) { return shrink * freepath_uniform(rng); }

/* The parameters of the scene, an object within the request: { "name": { .. } }. */
static const char *parameters(const freepath_medium *scene, const char *name) {
    const char *at = freepath_find(freepath_find(scene->request, "medium"), name);
    if (!at) freepath_die("the scene is not", name);
    return at;
}

/* The density x/2 on [0, 2], by inversion. */
static void ramp(const freepath_medium *scene, freepath_rng *rng, double *row) {
    (void)scene;
    row[0] = 2.0 * sqrt(first(rng));
}

/* The place of a uniform among weights. */
static size_t picked(const double *weights, size_t n, double u) {
    double sum = 0.0, below = 0.0;
    size_t last = 0;
    for (size_t i = 0; i < n; i++) sum += weights[i];
    for (size_t i = 0; i < n; i++) {
        below += weights[i];
        if (u * sum < below) return i;
        if (weights[i] > 0.0) last = i;
    }
    return last;
}

static void category(const freepath_medium *scene, freepath_rng *rng, double *row) {
    static double *weights = NULL;
    static size_t n = 0;
    if (!weights) n = freepath_list(parameters(scene, "discrete"), "weights", &weights);
    row[0] = (double)picked(weights, n, first(rng));
}

/* The cosine law about any normal: a point of the unit sphere on top of the normal (Shirley 2011). */
static void cosine(const freepath_medium *scene, freepath_rng *rng, double *row) {
    static double *normal = NULL;
    if (!normal && freepath_list(parameters(scene, "directions"), "normal", &normal) != 3) freepath_die("no", "normal");
    double z = 1.0 - 2.0 * first(rng), phi = 2.0 * acos(-1.0) * freepath_uniform(rng), r = sqrt(1.0 - z * z);
    double w[3] = {r * cos(phi) + normal[0], r * sin(phi) + normal[1], z + normal[2]};
    double length = sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
    for (int i = 0; i < 3; i++) row[i] = w[i] / length;
}

/* A table of two rows and two columns, 1 2 and 3 4, on the unit square. */
static void table(const freepath_medium *scene, freepath_rng *rng, double *row) {
    static const double values[4] = {1.0, 2.0, 3.0, 4.0};
    (void)scene;
    size_t cell = picked(values, 4, first(rng));
    row[0] = ((double)(cell % 2) + freepath_uniform(rng)) / 2.0;
    row[1] = ((double)(cell / 2) + freepath_uniform(rng)) / 2.0;
}

/* Estimates of 1/3: u^2. */
static void mean(const freepath_medium *scene, freepath_rng *rng, double *row) {
    double u = first(rng);
    (void)scene;
    row[0] = u * u;
}

int main(int argc, char **argv) {
    const freepath_kind kinds[] = {
        {"density", ramp}, {"discrete", category}, {"direction", cosine}, {"table_2d", table}, {"estimate", mean}};
    if (argc > 1 && strcmp(argv[1], "wrong") == 0) shrink = 0.95;
    return freepath_serve_rows(kinds, sizeof kinds / sizeof *kinds);
}
