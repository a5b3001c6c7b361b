// Turns a sampler in C++17 into a subject of freepath. One header, no dependency:
//
//     #include "freepath.hpp"
//     double tracker(const freepath::Medium &medium, freepath::Rng &rng) { .. }  // infinity for an escape
//     int main() { return freepath::serve({{"free_path", tracker}}); }
//
// A chromatic sampler gives a freepath::ChromaticDraw instead of a number.
//
// `freepath run --allow-commands` starts the program, tells it on standard input what to draw and reads doubles from standard
// output. So print to std::cerr, take every random number from `rng`, and nothing from the clock.
//
// Medium::mu knows every medium but `formula`; of that Medium::parameters has the JSON.
#pragma once

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

namespace freepath {

// As much of JSON as a request needs.
struct Json {
    double number = std::numeric_limits<double>::quiet_NaN();
    std::string text;
    std::vector<Json> items;
    std::map<std::string, Json> fields;

    bool has(const std::string &key) const { return fields.count(key) > 0; }
    const Json &operator[](const std::string &key) const {
        auto found = fields.find(key);
        if (found == fields.end()) throw std::runtime_error("the request has no " + key);
        return found->second;
    }
};

class JsonReader {
public:
    explicit JsonReader(const std::string &line) : at(line.c_str()) {}

    Json value() {
        Json json;
        switch (next()) {
            case '{': each('}', [&] { std::string key = string(); expect(':'); json.fields[key] = value(); }); break;
            case '[': each(']', [&] { json.items.push_back(value()); }); break;
            case '"': json.text = string(); break;
            case 't': case 'f': case 'n': while (std::isalpha(static_cast<unsigned char>(*at))) json.text += *at++; break;
            default: {
                char *end = nullptr;
                json.number = std::strtod(at, &end);
                if (end == at) throw std::runtime_error("the request is not JSON");
                at = end;
            }
        }
        return json;
    }

private:
    const char *at;

    char next() {
        while (*at == ' ' || *at == '\t' || *at == '\r') at++;
        return *at;
    }
    void expect(char c) {
        if (next() != c) throw std::runtime_error("the request is not JSON");
        at++;
    }
    template <class Read> void each(char close, Read read) {
        at++;
        while (next() != close) {
            read();
            if (next() == ',') at++; else if (*at != close) throw std::runtime_error("the request is not JSON");
        }
        at++;
    }
    std::string string() {
        std::string text;
        expect('"');
        while (*at && *at != '"') {
            if (*at == '\\' && at[1]) at++; // \u is not read: the names of the protocol are ASCII
            text += *at++;
        }
        expect('"');
        return text;
    }
};

using Rng = std::mt19937_64;

// Uniform in [0, 1), of 53 bits.
inline double uniform(Rng &rng) { return static_cast<double>(rng() >> 11) * 0x1p-53; }

// In segment k, up to ends[k], mu is at most mu_bar[k].
struct Majorants {
    std::vector<double> ends, mu_bar;

    double at(double t) const {
        if (mu_bar.empty()) throw std::runtime_error("a medium of channels has no majorant");
        auto k = static_cast<std::size_t>(std::upper_bound(ends.begin(), ends.end(), t) - ends.begin());
        return mu_bar[std::min(k, mu_bar.size() - 1)];
    }
    double greatest() const {
        if (mu_bar.empty()) throw std::runtime_error("a medium of channels has no majorant");
        return *std::max_element(mu_bar.begin(), mu_bar.end());
    }
};

// The extinction along the ray.
struct Medium {
    double length = 0.0;
    Majorants majorants;
    // Of a chromatic medium: extinction and scattering of each channel.
    std::vector<double> sigma_t, sigma_s;
    // The medium as the case has it, and how it is called.
    std::string name;
    Json parameters;
    // Extinction at a distance, 1/length.
    std::function<double(double)> mu;

    explicit Medium(const Json &request) : length(request["length"].number) {
        for (const Json &segment : request["majorants"].items) {
            majorants.ends.push_back(segment["end"].number);
            majorants.mu_bar.push_back(segment["mu_bar"].number);
        }
        std::tie(name, parameters) = *request["medium"].fields.begin();
        channels(request["medium"], 1.0);
        mu = request.has("table") ? table(request["table"].text, request["rows_per_cell"].number)
                                  : closed_form(request["medium"]);
    }

private:
    using Mu = std::function<double(double)>;

    // Reads them, if the medium has channels.
    void channels(const Json &medium, double by) {
        const auto &[is, p] = *medium.fields.begin();
        if (is == "chromatic") {
            for (const Json &sigma : p["sigma_t"].items) sigma_t.push_back(by * sigma.number);
            for (const Json &sigma : p["sigma_s"].items) sigma_s.push_back(by * sigma.number);
        } else if (p.has("medium")) {
            channels(p["medium"], is == "scaled" ? by * p["by"].number : by);
        }
    }

    static double length_of(const Json &medium) {
        const auto &[is, p] = *medium.fields.begin();
        if (is == "scaled" || is == "reversed") return length_of(p["medium"]);
        return is == "segment" ? p["to"].number - p["from"].number : p["length"].number;
    }

    // Media that are polynomials between breaks come as a table.
    static Mu closed_form(const Json &medium) {
        const std::string is = medium.fields.begin()->first;
        const Json &p = medium.fields.begin()->second;
        if (is == "gaussian") {
            double base = p.has("base") ? p["base"].number : 0.0, peak = p["peak"].number;
            double center = p["center"].number, width = p["width"].number;
            return [=](double t) { return base + peak * std::exp(-0.5 * std::pow((t - center) / width, 2)); };
        }
        if (is == "exponential") {
            double mu0 = p["mu0"].number, height = p["scale_height"].number;
            return [=](double t) { return mu0 * std::exp(-t / height); };
        }
        if (is == "sinusoid") {
            double mean = p["mean"].number, amplitude = p["amplitude"].number;
            double per_length = 2.0 * std::acos(-1.0) * p["frequency"].number, phase = p.has("phase") ? p["phase"].number : 0.0;
            return [=](double t) { return mean * (1.0 + amplitude * std::sin(per_length * t + phase)); };
        }
        if (is == "scaled") return [by = p["by"].number, of = closed_form(p["medium"])](double t) { return by * of(t); };
        if (is == "segment") return [at = p["from"].number, of = closed_form(p["medium"])](double t) { return of(at + t); };
        if (is == "reversed") return [end = length_of(medium), of = closed_form(p["medium"])](double t) { return of(end - t); };
        return [is](double) -> double {
            throw std::runtime_error("freepath.hpp does not know mu(t) of the medium " + is + ": write it yourself");
        };
    }

    // Through the nodes of each cell: Lagrange's polynomial.
    static Mu table(const std::string &path, double rows_per_cell) {
        std::ifstream file(path);
        std::string head;
        std::vector<double> ts, mus;
        char comma = 0;
        std::getline(file, head);
        for (double t, mu; file >> t >> comma >> mu;) ts.push_back(t), mus.push_back(mu);
        auto n = static_cast<std::size_t>(rows_per_cell);
        if (n < 2 || ts.size() < n) throw std::runtime_error("cannot read " + path);
        return [=](double t) {
            std::size_t low = 0, high = ts.size() / n; // t is in cell low, before cell high
            while (high - low > 1) {
                std::size_t middle = low + (high - low) / 2;
                (ts[middle * n] <= t ? low : high) = middle;
            }
            const double *at = ts.data() + low * n, *mu = mus.data() + low * n;
            double u = (t - at[0]) / (at[n - 1] - at[0]) * static_cast<double>(n - 1), sum = 0.0;
            for (std::size_t k = 0; k < n; k++) {
                double weight = 1.0;
                for (std::size_t j = 0; j < n; j++)
                    if (j != k) weight *= (u - static_cast<double>(j)) / (static_cast<double>(k) - static_cast<double>(j));
                sum += weight * mu[k];
            }
            return sum;
        };
    }
};

// A row of a chromatic sampler: where the light scatters, or that it reaches the surface, and a weight for each channel.
struct ChromaticDraw {
    double t;
    bool surface;
    std::vector<double> weights;
};

using Sampler = std::variant<std::function<double(const Medium &, Rng &)>, std::function<ChromaticDraw(const Medium &, Rng &)>>;

namespace detail {
inline void write(double x) {
    std::uint64_t bits;
    char bytes[8];
    std::memcpy(&bits, &x, 8);
    for (int i = 0; i < 8; i++) bytes[i] = static_cast<char>(bits >> (8 * i) & 0xff);
    std::cout.write(bytes, 8);
}

inline void write(const ChromaticDraw &draw, std::size_t channels) {
    if (draw.weights.size() != channels)
        throw std::runtime_error("the sampler gave " + std::to_string(draw.weights.size()) + " weights for " +
                                 std::to_string(channels) + " channels");
    write(draw.t);
    write(draw.surface ? 1.0 : 0.0);
    for (double weight : draw.weights) write(weight);
}

inline void answer(const std::map<std::string, Sampler> &samplers) {
    std::string line;
    std::getline(std::cin, line);
    const Json request = JsonReader(line).value();
    if (request["protocol"].number != 1.0) throw std::runtime_error("unknown protocol");
    const std::string kind = request["kind"].text;
    auto sampler = samplers.find(kind);
    if (sampler == samplers.end() || sampler->second.index() != (kind == "chromatic"))
        throw std::runtime_error("there is no sampler of the kind " + kind);
    const Medium medium(request);
    Rng rng(static_cast<std::uint64_t>(request["seed"].number));
    auto draws = static_cast<std::uint64_t>(request["draws"].number);
    for (std::uint64_t i = 0; i < draws; i++) {
        if (auto number = std::get_if<0>(&sampler->second)) write((*number)(medium, rng));
        else write(std::get<1>(sampler->second)(medium, rng), medium.sigma_t.size());
    }
    if (!std::cout.flush()) throw std::runtime_error("cannot write the draws");
}
}  // namespace detail

// Answers one request: `free_path` gives t, infinity for an escape; `transmittance` an estimate; `chromatic` a row.
inline int serve(const std::map<std::string, Sampler> &samplers) {
    std::ios::sync_with_stdio(false);
    try {
        detail::answer(samplers);
        return 0;
    } catch (const std::exception &why) {
        std::cerr << "freepath.hpp: " << why.what() << "\n";
        return 2;
    }
}

}  // namespace freepath
