// Writes the extinction at the distances in a file to another: mu_cpp FROM TO. It draws nothing.
#include "../cpp/freepath.hpp"

#include <iomanip>

int main(int, char **argv) {
    return freepath::serve({{"free_path", [&](const freepath::Medium &medium, freepath::Rng &) -> double {
        std::ifstream places(argv[1]);
        std::ofstream out(argv[2]);
        for (double t; places >> t;) out << std::setprecision(17) << medium.mu(t) << "\n";
        throw std::runtime_error("done");
    }}});
}
