// Delta tracking and ratio tracking. With the argument `late` they look mu up a step late: wrong samplers.
#include "../cpp/freepath.hpp"

using freepath::Medium;
using freepath::Rng;

double late = 0.0;

double look_up(const Medium &medium, double t) { return medium.mu(std::min(t + late, medium.length)); }

double delta_tracking(const Medium &medium, Rng &rng) {
    const double mu_bar = medium.majorants.greatest();
    for (double t = 0.0;;) {
        t -= std::log(1.0 - freepath::uniform(rng)) / mu_bar;
        if (t >= medium.length) return INFINITY;
        if (freepath::uniform(rng) * mu_bar < look_up(medium, t)) return t;
    }
}

double ratio_tracking(const Medium &medium, Rng &rng) {
    const double mu_bar = medium.majorants.greatest();
    double weight = 1.0;
    for (double t = 0.0;;) {
        t -= std::log(1.0 - freepath::uniform(rng)) / mu_bar;
        if (t >= medium.length) return weight;
        weight *= 1.0 - look_up(medium, t) / mu_bar;
    }
}

int main(int argc, char **argv) {
    if (argc > 1 && std::string(argv[1]) == "late") late = 0.1;
    return freepath::serve({{"free_path", delta_tracking}, {"transmittance", ratio_tracking}});
}
