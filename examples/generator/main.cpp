// Makes the sample traffic of examples/traffic, the same bytes every time.
//
//   generate_traffic DIRECTORY            writes the files
//   generate_traffic --check DIRECTORY    compares them; status 1 if one differs

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include "capture.hpp"

namespace {

bool write(const std::string& path, const std::string& bytes) {
    std::ofstream file(path, std::ios::binary);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file) std::fprintf(stderr, "generate_traffic: cannot write %s\n", path.c_str());
    return static_cast<bool>(file);
}

bool same(const std::string& path, const std::string& bytes) {
    std::ifstream file(path, std::ios::binary);
    const std::string found{std::istreambuf_iterator<char>(file), {}};
    if (found == bytes) return true;
    std::fprintf(stderr, "generate_traffic: %s is not what this program makes\n", path.c_str());
    return false;
}

}  // namespace

int main(int argc, char** argv) {
    const bool check = argc == 3 && std::string_view(argv[1]) == "--check";
    if (argc != 2 && !check) {
        std::fputs("usage: generate_traffic [--check] DIRECTORY\n", stderr);
        return 2;
    }
    const std::string folder = std::string(argv[argc - 1]) + '/';
    const auto each = check ? same : write;
    bool good = each(folder + "robot.daisy", traffic::robot());
    good &= each(folder + "greenhouse.can", traffic::greenhouse());
    good &= each(folder + "warehouse.gateway", traffic::warehouse());
    return good ? 0 : 1;
}
