// Turns a sampler in C++17 into a subject of freepath. One header, no dependency:
//
//     #include "freepath.hpp"
//     double tracker(const freepath::Medium &medium, freepath::Rng &rng) { .. }  // infinity for an escape
//     int main() { return freepath::serve({{"free_path", tracker}}); }
//
// A chromatic sampler gives a freepath::ChromaticDraw instead of a number. A row of several columns is a std::vector<double>: of the
// kind `direction` x, y, z, of `table_2d` x, y. A case with a scene in the place of a medium gives its name and its parameters.
//
// `freepath run --allow-commands` starts the program, tells it on standard input what to draw and reads doubles from standard
// output. So print to std::cerr, take every random number from `rng`, and nothing from the clock.
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

// The extinction along the ray; of a scene without a ray its name and its parameters alone.
struct Medium {
    double length = 0.0;
    Majorants majorants;
    // Of a chromatic medium: extinction and scattering of each channel.
    std::vector<double> sigma_t, sigma_s;
    // The medium as the case has it, and how it is called.
    std::string name;
    Json parameters;
    // Extinction at t, 0 <= t <= length, in 1/length. A chromatic medium has that of its channels instead.
    std::function<double(double)> mu;

    explicit Medium(const Json &request) : length(request["length"].number) {
        for (const Json &segment : request["majorants"].items) {
            majorants.ends.push_back(segment["end"].number);
            majorants.mu_bar.push_back(segment["mu_bar"].number);
        }
        std::tie(name, parameters) = *request["medium"].fields.begin();
        if (request.has("sigma_t")) {
            for (const Json &sigma : request["sigma_t"].items) sigma_t.push_back(sigma.number);
            for (const Json &sigma : request["sigma_s"].items) sigma_s.push_back(sigma.number);
            mu = [](double) -> double { throw std::runtime_error("a medium of channels has sigma_t, not mu(t)"); };
        } else if (!request.has("table")) {
            mu = [](double) -> double { throw std::runtime_error("a scene without a ray has no mu(t)"); };
        } else {
            mu = table(request["table"].text, request["rows_per_cell"].number);
        }
    }

private:
    // The polynomial through the rows of each cell.
    static std::function<double(double)> table(const std::string &path, double rows_per_cell) {
        std::ifstream file(path);
        std::string head;
        std::vector<double> ts, terms;
        char comma = 0;
        std::getline(file, head);
        for (double t, mu; file >> t >> comma >> mu;) ts.push_back(t), terms.push_back(mu);
        auto n = static_cast<std::size_t>(rows_per_cell);
        if (n < 2 || ts.size() < n) throw std::runtime_error("cannot read " + path);
        for (std::size_t cell = 0; cell + n <= ts.size(); cell += n) differences(terms.data() + cell, n);
        return [n, ts = std::move(ts), terms = std::move(terms)](double t) {
            std::size_t low = 0, high = ts.size() / n; // t is in cell low, before cell high
            while (high - low > 1) {
                std::size_t middle = low + (high - low) / 2;
                (ts[middle * n] <= t ? low : high) = middle;
            }
            const double *at = ts.data() + low * n, *of = terms.data() + low * n;
            double s = (t - at[0]) / (at[n - 1] - at[0]) * static_cast<double>(n - 1), sum = 0.0;
            for (std::size_t k = n; k-- > 0;) sum = sum * (s - static_cast<double>(k)) + of[k];
            return sum < 0.0 ? 0.0 : sum; // by rounding
        };
    }

    // Newton's forward differences over their factorials.
    static void differences(double *mu, std::size_t n) {
        for (std::size_t order = 1; order < n; order++)
            for (std::size_t k = n - 1; k >= order; k--) mu[k] = (mu[k] - mu[k - 1]) / static_cast<double>(order);
    }
};

// A row of a chromatic sampler: where the light scatters, or that it reaches the surface, and a weight for each channel.
struct ChromaticDraw {
    double t;
    bool surface;
    std::vector<double> weights;
};

using Row = std::vector<double>;

using Sampler = std::variant<std::function<double(const Medium &, Rng &)>, std::function<ChromaticDraw(const Medium &, Rng &)>,
                             std::function<Row(const Medium &, Rng &)>>;

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

inline void write(const Row &row, std::size_t columns) {
    if (row.size() != columns)
        throw std::runtime_error("the sampler gave a row of " + std::to_string(row.size()) + " numbers for " +
                                 std::to_string(columns) + " columns");
    for (double number : row) write(number);
}

// Which of the samplers gives such a row: a number, a chromatic draw, or several numbers.
inline bool fits(const Sampler &sampler, const std::string &kind, std::size_t columns) {
    return kind == "chromatic" ? sampler.index() == 1 : columns > 1 ? sampler.index() == 2 : sampler.index() != 1;
}

inline void answer(const std::map<std::string, Sampler> &samplers) {
    std::string line;
    std::getline(std::cin, line);
    const Json request = JsonReader(line).value();
    if (request["protocol"].number != 1.0) throw std::runtime_error("unknown protocol");
    const std::string kind = request["kind"].text;
    const std::size_t columns = request["columns"].items.size();
    auto sampler = samplers.find(kind);
    if (sampler == samplers.end() || !fits(sampler->second, kind, columns))
        throw std::runtime_error("there is no sampler of the kind " + kind);
    const Medium medium(request);
    Rng rng(static_cast<std::uint64_t>(request["seed"].number));
    auto draws = static_cast<std::uint64_t>(request["draws"].number);
    for (std::uint64_t i = 0; i < draws; i++) {
        if (auto number = std::get_if<0>(&sampler->second)) write((*number)(medium, rng));
        else if (auto row = std::get_if<2>(&sampler->second)) write((*row)(medium, rng), columns);
        else write(std::get<1>(sampler->second)(medium, rng), medium.sigma_t.size());
    }
    if (!std::cout.flush()) throw std::runtime_error("cannot write the draws");
}
}  // namespace detail

// Answers one request: `free_path` gives t, infinity for an escape; `transmittance` an estimate; `chromatic` a ChromaticDraw;
// other kinds a number, or a Row of their columns.
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
