// Delta tracking, ratio tracking, and a chromatic sampler. With the argument `late` they look mu up a step late, and the
// weights of channels are too large: wrong samplers.
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

// A channel is drawn, and its distance weighted by the mean density of all (the balance heuristic).
freepath::ChromaticDraw one_channel(const Medium &medium, Rng &rng) {
    const std::size_t channels = medium.sigma_t.size();
    const double sigma = medium.sigma_t[static_cast<std::size_t>(freepath::uniform(rng) * static_cast<double>(channels))];
    const double t = -std::log(1.0 - freepath::uniform(rng)) / sigma;
    freepath::ChromaticDraw draw{std::min(t, medium.length), t >= medium.length, {}};
    double density = 0.0;
    for (std::size_t c = 0; c < channels; c++) {
        const double beam = std::exp(-medium.sigma_t[c] * draw.t);
        density += beam * (draw.surface ? 1.0 : medium.sigma_t[c]) / static_cast<double>(channels);
        draw.weights.push_back(beam * (draw.surface ? 1.0 : medium.sigma_s[c]));
    }
    for (double &weight : draw.weights) weight *= (late > 0.0 ? 1.05 : 1.0) / density;
    return draw;
}

int main(int argc, char **argv) {
    if (argc > 1 && std::string(argv[1]) == "late") late = 0.1;
    return freepath::serve({{"free_path", delta_tracking}, {"transmittance", ratio_tracking}, {"chromatic", one_channel}});
}
