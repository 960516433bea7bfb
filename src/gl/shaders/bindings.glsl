// Where programs of this module find their resources: the numbers of the bindings, for GLSL and C++ alike,
// which is why there is nothing else in here.

// Storage blocks.
const int kWordsStorage = 0;
