/* Writes the extinction at the distances in a file to another: mu_c FROM TO. It draws nothing. */
#include "../c/freepath.h"

static const char *from, *to;

static double look_up(const freepath_medium *medium, freepath_rng *rng) {
    FILE *places = fopen(from, "r"), *out = fopen(to, "w");
    double t;
    (void)rng;
    if (!places || !out) exit(4);
    while (fscanf(places, "%lf", &t) == 1) fprintf(out, "%.17g\n", freepath_mu(medium, t));
    fclose(out), fclose(places);
    exit(3);
}

int main(int argc, char **argv) {
    if (argc < 3) return 4;
    from = argv[1], to = argv[2];
    return freepath_serve(look_up, NULL, NULL);
}
