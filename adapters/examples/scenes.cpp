// Samplers in scenes without a ray. With the argument `wrong` the uniform that all begin with is a little too small.
#include "../cpp/freepath.hpp"

static double shrink = 1.0;

static double first(freepath::Rng &rng) { return shrink * freepath::uniform(rng); }

// The density x/2 on [0, 2], by inversion.
static double ramp(const freepath::Medium &, freepath::Rng &rng) { return 2.0 * std::sqrt(first(rng)); }

// The place of a uniform among weights.
static std::size_t picked(const std::vector<double> &weights, double u) {
    double sum = 0.0, below = 0.0;
    for (double weight : weights) sum += weight;
    std::size_t last = 0;
    for (std::size_t i = 0; i < weights.size(); i++) {
        below += weights[i];
        if (u * sum < below) return i;
        if (weights[i] > 0.0) last = i;
    }
    return last;
}

static double category(const freepath::Medium &scene, freepath::Rng &rng) {
    std::vector<double> weights;
    for (const freepath::Json &weight : scene.parameters["weights"].items) weights.push_back(weight.number);
    return static_cast<double>(picked(weights, first(rng)));
}

// The cosine law about any normal: a point of the unit sphere on top of the normal (Shirley 2011).
static freepath::Row cosine(const freepath::Medium &scene, freepath::Rng &rng) {
    double z = 1.0 - 2.0 * first(rng), phi = 2.0 * std::acos(-1.0) * freepath::uniform(rng), r = std::sqrt(1.0 - z * z);
    freepath::Row w = {r * std::cos(phi), r * std::sin(phi), z};
    double square = 0.0;
    for (std::size_t i = 0; i < 3; i++) {
        w[i] += scene.parameters["normal"].items[i].number;
        square += w[i] * w[i];
    }
    for (double &x : w) x /= std::sqrt(square);
    return w;
}

static freepath::Row table(const freepath::Medium &scene, freepath::Rng &rng) {
    const auto &rows = scene.parameters["values"].items, &domain = scene.parameters["domain"].items;
    std::vector<double> values;
    for (const freepath::Json &row : rows)
        for (const freepath::Json &value : row.items) values.push_back(value.number);
    std::size_t columns = rows[0].items.size(), cell = picked(values, first(rng));
    double along = (static_cast<double>(cell % columns) + freepath::uniform(rng)) / static_cast<double>(columns);
    double across = (static_cast<double>(cell / columns) + freepath::uniform(rng)) / static_cast<double>(rows.size());
    auto at = [&](std::size_t side, double share) {
        double from = domain[side].items[0].number, to = domain[side].items[1].number;
        return from + (to - from) * share;
    };
    return {at(0, along), at(1, across)};
}

// Estimates of 1/3: u^2.
static double mean(const freepath::Medium &, freepath::Rng &rng) {
    double u = first(rng);
    return u * u;
}

int main(int argc, char **argv) {
    if (argc > 1 && std::string(argv[1]) == "wrong") shrink = 0.95;
    return freepath::serve(
        {{"density", ramp}, {"discrete", category}, {"direction", cosine}, {"table_2d", table}, {"estimate", mean}});
}
