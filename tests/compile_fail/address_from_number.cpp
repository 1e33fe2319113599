// expect: conversion from|no viable conversion
#include "trama/daisy/format.hpp"

trama::daisy::address composed = trama::daisy::board(1, 2);
trama::daisy::address number = 0x12;  // wrong
