// Where programs of this module find their resources: the numbers of the bindings, for GLSL and C++ alike,
// which is why there is nothing else in here. Numbers of one kind that one program uses differ; programs that
// do not meet share them.

// Storage blocks.
const int kQueriesStorage = 0;
const int kAnswersStorage = 1;
