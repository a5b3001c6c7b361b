/* freepath: judge free-path samplers and transmittance estimators from C and C++. Made by cbindgen; do not edit. */

#ifndef FREEPATH_H
#define FREEPATH_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

// The verdict of a check. The numbers are those of the command's exit codes.
typedef enum fp_verdict {
  // No claim is rejected.
  FP_PASS = 0,
  // A claim is rejected; a wrong alarm has a probability of at most 1e-6.
  FP_FAIL = 1,
  // The arguments cannot be used; the message says which and why.
  FP_UNUSABLE = 2,
  // The draws do not tell; the message says why.
  FP_INCONCLUSIVE = 4,
} fp_verdict;

// The medium along a ray. Every look-up is counted and held against the majorant.
typedef struct fp_medium fp_medium;

// Random numbers. Every draw must take its own from here, or a replay and the scripted streams cannot work.
typedef struct fp_rng fp_rng;

// Effort and claims of a check. Take `fp_default_options()` and change what is to be changed.
typedef struct fp_options {
  // The seed of all uniforms; 1 by default.
  uint64_t seed;
  // Draws of the first stage, rounded up to blocks of 16,384; 131,072 by default. A suspect gets twice as many fresh ones.
  uint64_t draws;
  // The most by which any claim may be off, 6e-8 for a sampler in single precision; 0 by default.
  double tolerance;
  // Bits of the uniforms that the sampler makes of its own, 24 for single precision; 53 by default.
  uint32_t resolution_bits;
  // Threads that may call the callback at a time, at most 1024; 1 by default. The verdict does not depend on it.
  uint32_t threads;
  // True if the callback claims no look-up above the majorant, as delta tracking must and ratio tracking need not;
  // true by default.
  bool bounded;
} fp_options;

// Draws one number: a free path (infinity for an escape), or an estimate of the transmittance.
//
// It must not throw (`fp_caught` makes NaN of an exception), and must not keep `medium` or `rng` after it returns. `user` is what was handed to the check.
typedef double (*fp_sample)(void *user, const struct fp_medium *medium, struct fp_rng *rng);

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

// The options that are used where none are given.
struct fp_options fp_default_options(void);

// Judges free paths: `sample` returns the distance of a collision, or infinity for an escape.
//
// `medium` is the medium of a case file in JSON, such as `{"gaussian": {"peak": 4, "center": 0.9, "width": 0.25,
// "length": 2}}`; files that it names are relative to the working folder. `options` may be null. `message` gets at most
// `capacity` bytes of text that always ends with a zero, and may be null.
//
// # Safety
// Every pointer is null or valid; `sample` and `user` are ready for as many threads as the options allow.
enum fp_verdict fp_check_free_path(const char *medium,
                                   fp_sample sample,
                                   void *user,
                                   const struct fp_options *options,
                                   char *message,
                                   size_t capacity);

// Judges a transmittance estimator: `sample` returns an estimate of exp(-tau(length)). See `fp_check_free_path`.
//
// # Safety
// As for `fp_check_free_path`.
enum fp_verdict fp_check_transmittance(const char *medium,
                                       fp_sample sample,
                                       void *user,
                                       const struct fp_options *options,
                                       char *message,
                                       size_t capacity);

// The extinction at distance `t`, 1/length. NaN past the budget of look-ups, and for a null medium.
//
// # Safety
// `medium` is null or came with the callback that runs.
double fp_mu(const struct fp_medium *medium, double t);

// The length of the ray. NaN for a null medium.
//
// # Safety
// As for `fp_mu`.
double fp_length(const struct fp_medium *medium);

// The majorant at distance `t`, 1/length: an upper bound of the extinction on its segment. NaN for a null medium.
//
// # Safety
// As for `fp_mu`.
double fp_majorant(const struct fp_medium *medium,
                   double t);

// The number of majorant segments of the ray, at least 1; 0 for a null medium.
//
// # Safety
// As for `fp_mu`.
size_t fp_segments(const struct fp_medium *medium);

// The end of majorant segment `i`; that of the last is the length. NaN if there is no such segment.
//
// # Safety
// As for `fp_mu`.
double fp_segment_end(const struct fp_medium *medium, size_t i);

// The majorant on segment `i`, 1/length. NaN if there is no such segment.
//
// # Safety
// As for `fp_mu`.
double fp_segment_majorant(const struct fp_medium *medium, size_t i);

// A uniform number in [0, 1), a multiple of 2^-53. Past the budget of a block it is 1 - 2^-53 for ever, so that walks
// leave. NaN for a null generator.
//
// # Safety
// `rng` is null or came with the callback that runs.
double fp_uniform(struct fp_rng *rng);

// 64 random bits. Past the budget of a block all are set; 0 for a null generator.
//
// # Safety
// As for `fp_uniform`.
uint64_t fp_word(struct fp_rng *rng);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* FREEPATH_H */

#if defined(__cplusplus) && !defined(FREEPATH_CAUGHT)
#define FREEPATH_CAUGHT
// A callback from a function that may throw: an exception becomes NaN, and so the reason `non_finite`. C++17:
// `fp_check_free_path(medium, fp_caught<sample>, ..)`.
template <auto sample>
double fp_caught(void *user, const fp_medium *medium, fp_rng *rng) noexcept {
    try {
        return sample(user, medium, rng);
    } catch (...) {
        return NAN;
    }
}
#endif
