/* A check for C programs: says where it failed and ends the program. */
#ifndef RAVEL_TESTS_CHECK_H
#define RAVEL_TESTS_CHECK_H

#include <stdio.h>
#include <stdlib.h>

static void check_at(int holds, const char* what, const char* file, int line) {
    if (holds) return;
    fprintf(stderr, "%s:%d: %s\n", file, line, what);
    exit(1);
}
#define CHECK(what) check_at((what) != 0, #what, __FILE__, __LINE__)

#endif
