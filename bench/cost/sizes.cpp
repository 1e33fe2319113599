#include <cstdio>

#include "trama/trama.hpp"

int main() {
    std::printf("daisy::decoder %zu\n", sizeof(trama::daisy::decoder));
    std::printf("can::reassembler %zu\n", sizeof(trama::can::reassembler));
    std::printf("gateway::decoder %zu\n", sizeof(trama::gateway::decoder));
    std::printf("daisy::event %zu\n", sizeof(trama::daisy::event));
    std::printf("can::event %zu\n", sizeof(trama::can::event));
    std::printf("gateway::event %zu\n", sizeof(trama::gateway::event));
}
