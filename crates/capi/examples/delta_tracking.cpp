/* Judges a delta tracker and a ratio tracker of C++, and shows that a wrong one is caught.

     cargo build --release -p freepath-capi
     c++ -std=c++17 -I crates/capi/include crates/capi/examples/delta_tracking.cpp \
         target/release/libfreepath.a -o delta_tracking -lpthread -ldl -lm
     ./delta_tracking
*/

#include "freepath.h"

#include <cmath>
#include <cstdio>

namespace {

constexpr const char *medium =
    R"({"gaussian": {"peak": 4.0, "center": 0.9, "width": 0.25, "length": 2.0, "base": 0.2}})";

struct Tracker {
    double look_up_shift = 0.0;  // a look-up this far behind the particle: a planted fault
};

double delta_tracking(void *user, const fp_medium *medium, fp_rng *rng) {
    const auto &tracker = *static_cast<const Tracker *>(user);
    const double length = fp_length(medium), mu_bar = fp_majorant(medium, 0.0);
    double t = 0.0;
    for (;;) {
        t -= std::log1p(-fp_uniform(rng)) / mu_bar;
        if (!(t < length)) return INFINITY;
        const double at = std::fmax(t - tracker.look_up_shift, 0.0);
        if (fp_uniform(rng) * mu_bar < fp_mu(medium, at)) return t;
    }
}

double ratio_tracking(void *, const fp_medium *medium, fp_rng *rng) {
    const double length = fp_length(medium), mu_bar = fp_majorant(medium, 0.0);
    double t = 0.0, weight = 1.0;
    for (;;) {
        t -= std::log1p(-fp_uniform(rng)) / mu_bar;
        if (!(t < length)) return weight;
        weight *= 1.0 - fp_mu(medium, t) / mu_bar;
    }
}

double throwing(void *, const fp_medium *, fp_rng *) { throw 1; }

bool says(const char *name, fp_verdict verdict, fp_verdict expected, const char *message) {
    std::printf("%s %s\n%s\n", verdict == expected ? "ok" : "NO", name, message);
    return verdict == expected;
}

}  // namespace

int main() {
    char message[2048];
    Tracker right, wrong{0.02};
    bool all = true;
    auto verdict = fp_check_free_path(medium, delta_tracking, &right, nullptr, message, sizeof message);
    all &= says("delta tracking", verdict, FP_PASS, message);
    verdict = fp_check_transmittance(medium, ratio_tracking, nullptr, nullptr, message, sizeof message);
    all &= says("ratio tracking", verdict, FP_PASS, message);
    verdict = fp_check_free_path(medium, delta_tracking, &wrong, nullptr, message, sizeof message);
    all &= says("delta tracking with a stale look-up must fail", verdict, FP_FAIL, message);
    // an exception must not cross the border: it becomes NaN
    verdict = fp_check_free_path(medium, fp_caught<throwing>, nullptr, nullptr, message, sizeof message);
    all &= says("a function that throws must fail", verdict, FP_FAIL, message);
    return all ? 0 : 1;
}
