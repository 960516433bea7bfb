// Where programs of this module find their resources: the numbers of the bindings, for GLSL and C++ alike,
// which is why there is nothing else in here.

// Storage blocks.
const int kWordsStorage = 0;

// Textures.
const int kUnusedTextures = 16; // and after it: beyond all units that other programs use
