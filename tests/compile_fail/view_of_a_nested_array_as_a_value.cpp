// expect: conversion from|no viable conversion
// Nested orders come as views, element by element.
#include "trama/core/view.hpp"
#include "trama/gateway/format.hpp"

using trama::gateway::cart_state;
using trama::gateway::transit_order;

void use(trama::view<cart_state> view) {
    const trama::view<transit_order> first = view.get<&cart_state::orders>(0);
    (void)first.get<&transit_order::level>();
    [[maybe_unused]] const transit_order whole = view.get<&cart_state::orders>(0);  // wrong
}
