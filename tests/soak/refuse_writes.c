// SPDX-License-Identifier: Apache-2.0
// A disk that is full, or broken, from a chosen moment on: preloaded (LD_PRELOAD) into a program, it refuses
// the program's calls that write to files of a folder.
//
// REFUSE_FOLDER  the folder; what lies elsewhere is left alone
// REFUSE_FROM    the first call that is refused, counted from 1; 0 or not set: none is, they are only counted
// REFUSE_ERROR   the number of the error, as in errno.h; without: that of a full disk
// REFUSE_ONCE    set: only that one call is refused, those after it are not
// REFUSE_COUNT   a file into which the number of such calls is written when the program ends
//
// A program may write in the library's own name (fwrite) or by the system's (write): both are counted where
// the program calls them.
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

#define VS_MOST_FILES 4096

static atomic_int calls;
static atomic_char isWatched[VS_MOST_FILES]; // by the number of a descriptor: of a file of the folder

// The function of that name that this one stands before.
#define NEXT(type, name) ((type)dlsym(RTLD_NEXT, name))

static int liesInFolder(const char* path) {
    const char* folder = getenv("REFUSE_FOLDER");
    if (folder == NULL || path == NULL) {
        return 0;
    }
    char whole[2 * PATH_MAX];
    if (path[0] == '/') {
        snprintf(whole, sizeof whole, "%s", path);
    } else {
        char here[PATH_MAX];
        snprintf(whole, sizeof whole, "%s/%s", getcwd(here, sizeof here) != NULL ? here : "", path);
    }
    const size_t length = strlen(folder);
    return strncmp(whole, folder, length) == 0 && (whole[length] == '/' || whole[length] == '\0');
}

// Counts one call. Whether it is to be refused: errno says why. `lasts`: so are the calls after the first
// refused.
static int isRefusedFor(int lasts) {
    const int number = atomic_fetch_add(&calls, 1) + 1;
    const char* from = getenv("REFUSE_FROM");
    const int first = from != NULL ? atoi(from) : 0;
    if (first == 0 || number < first || (number > first && !lasts)) {
        return 0;
    }
    const char* error = getenv("REFUSE_ERROR");
    errno = error != NULL ? atoi(error) : ENOSPC;
    return 1;
}

static int isRefused(void) { return isRefusedFor(getenv("REFUSE_ONCE") == NULL); }

static int isWatchedFile(int file) { return file >= 0 && file < VS_MOST_FILES && isWatched[file]; }
static int isRefusedTo(int file) { return isWatchedFile(file) && isRefused(); }

static int watched(int file, int isToWatch) {
    if (file >= 0 && file < VS_MOST_FILES) {
        isWatched[file] = (char)isToWatch;
    }
    return file;
}

__attribute__((destructor)) static void tell(void) {
    const char* path = getenv("REFUSE_COUNT");
    FILE* out = path != NULL ? NEXT(FILE * (*)(const char*, const char*), "fopen")(path, "a") : NULL;
    if (out != NULL) {
        fprintf(out, "%d\n", atomic_load(&calls));
        fclose(out);
    }
}

// --- files that are opened

// Files that are opened for reading are watched too: they may be synced.
static int openWith(int folder, const char* path, int flags, mode_t mode) {
    const int isInFolder = liesInFolder(path);
    const int makes = (flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE;
    if (isInFolder && makes && isRefused()) {
        return -1;
    }
    return watched(NEXT(int (*)(int, const char*, int, mode_t), "openat")(folder, path, flags, mode),
                   isInFolder);
}

static mode_t modeOf(int flags, va_list rest) {
    return (flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE ? va_arg(rest, mode_t) : 0;
}

#define VS_OPEN(name)                                                                                        \
    int name(const char* path, int flags, ...) {                                                             \
        va_list rest;                                                                                        \
        va_start(rest, flags);                                                                               \
        const mode_t mode = modeOf(flags, rest);                                                             \
        va_end(rest);                                                                                        \
        return openWith(AT_FDCWD, path, flags, mode);                                                        \
    }
#define VS_OPENAT(name)                                                                                      \
    int name(int folder, const char* path, int flags, ...) {                                                 \
        va_list rest;                                                                                        \
        va_start(rest, flags);                                                                               \
        const mode_t mode = modeOf(flags, rest);                                                             \
        va_end(rest);                                                                                        \
        return openWith(folder, path, flags, mode);                                                          \
    }
#define VS_FOPEN(name)                                                                                       \
    FILE* name(const char* path, const char* mode) {                                                         \
        const int writes = strpbrk(mode, "wa+") != NULL && liesInFolder(path);                               \
        if (writes && isRefused()) {                                                                         \
            return NULL;                                                                                     \
        }                                                                                                    \
        FILE* file = NEXT(FILE * (*)(const char*, const char*), #name)(path, mode);                          \
        if (file != NULL) {                                                                                  \
            watched(fileno(file), writes);                                                                   \
        }                                                                                                    \
        return file;                                                                                         \
    }
VS_OPEN(open)
VS_OPEN(open64)
VS_OPENAT(openat)
VS_OPENAT(openat64)
VS_FOPEN(fopen)
VS_FOPEN(fopen64)

int close(int file) {
    watched(file, 0);
    return NEXT(int (*)(int), "close")(file);
}

// --- what is written into them

ssize_t write(int file, const void* bytes, size_t count) {
    return isRefusedTo(file) ? -1 : NEXT(ssize_t(*)(int, const void*, size_t), "write")(file, bytes, count);
}

ssize_t writev(int file, const struct iovec* pieces, int count) {
    return isRefusedTo(file) ? -1
                             : NEXT(ssize_t(*)(int, const struct iovec*, int), "writev")(file, pieces, count);
}

ssize_t pwrite(int file, const void* bytes, size_t count, off_t at) {
    return isRefusedTo(file)
               ? -1
               : NEXT(ssize_t(*)(int, const void*, size_t, off_t), "pwrite")(file, bytes, count, at);
}

ssize_t pwrite64(int file, const void* bytes, size_t count, off64_t at) {
    return isRefusedTo(file)
               ? -1
               : NEXT(ssize_t(*)(int, const void*, size_t, off64_t), "pwrite64")(file, bytes, count, at);
}

size_t fwrite(const void* bytes, size_t size, size_t count, FILE* file) {
    return isRefusedTo(fileno(file))
               ? 0
               : NEXT(size_t(*)(const void*, size_t, size_t, FILE*), "fwrite")(bytes, size, count, file);
}

int fflush(FILE* file) {
    return file != NULL && isRefusedTo(fileno(file)) ? EOF : NEXT(int (*)(FILE*), "fflush")(file);
}

// A file that cannot be closed well is closed all the same.
int fclose(FILE* file) {
    const int isBad = isRefusedTo(fileno(file));
    const int error = errno;
    watched(fileno(file), 0);
    const int result = NEXT(int (*)(FILE*), "fclose")(file);
    if (isBad) {
        errno = error;
        return EOF;
    }
    return result;
}

int fsync(int file) { return isRefusedTo(file) ? -1 : NEXT(int (*)(int), "fsync")(file); }
int fdatasync(int file) { return isRefusedTo(file) ? -1 : NEXT(int (*)(int), "fdatasync")(file); }
int ftruncate(int file, off_t size) {
    return isRefusedTo(file) ? -1 : NEXT(int (*)(int, off_t), "ftruncate")(file, size);
}
int ftruncate64(int file, off64_t size) {
    return isRefusedTo(file) ? -1 : NEXT(int (*)(int, off64_t), "ftruncate64")(file, size);
}

// --- names: a new one may find no room, but those that are there are exchanged and given back on a full disk
// too

int rename(const char* from, const char* to) {
    return liesInFolder(to) && isRefusedFor(0) ? -1
                                               : NEXT(int (*)(const char*, const char*), "rename")(from, to);
}

int renameat2(int fromFolder, const char* from, int toFolder, const char* to, unsigned flags) {
    return liesInFolder(to) && isRefusedFor(0) ? -1
                                               : NEXT(int (*)(int, const char*, int, const char*, unsigned),
                                                      "renameat2")(fromFolder, from, toFolder, to, flags);
}

int mkdir(const char* path, mode_t mode) {
    return liesInFolder(path) && isRefused() ? -1 : NEXT(int (*)(const char*, mode_t), "mkdir")(path, mode);
}
