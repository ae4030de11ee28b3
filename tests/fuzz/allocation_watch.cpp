#include "allocation_watch.h"

#include <cstdlib>

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define LDS_UNDER_SANITIZER
#endif
#endif
#if defined(__SANITIZE_ADDRESS__)
#define LDS_UNDER_SANITIZER
#endif

namespace {

thread_local bool t_watching = false;
thread_local std::size_t t_largest = 0;

[[maybe_unused]] void note(std::size_t size)
{
    if (t_watching && size > t_largest)
        t_largest = size;
}

} // namespace

#if defined(LDS_UNDER_SANITIZER)

// sanitizer/allocator_interface.h, which not every compiler package installs.
extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*onMalloc)(const volatile void*, std::size_t),
                                                         void (*onFree)(const volatile void*));

namespace {

const int hooked = __sanitizer_install_malloc_and_free_hooks(
    [](const volatile void*, std::size_t size) { note(size); }, [](const volatile void*) {});

} // namespace

bool fuzz::AllocationWatch::works() { return hooked != 0; }

#elif defined(__GLIBC__)

// Replacing the allocator in the program itself is glibc's documented way of interposing.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);

void* malloc(std::size_t size)
{
    note(size);
    return __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size)
{
    std::size_t bytes = 0;
    note(__builtin_mul_overflow(count, size, &bytes) ? std::size_t(-1) : bytes);
    return __libc_calloc(count, size);
}

void* realloc(void* memory, std::size_t size)
{
    note(size);
    return __libc_realloc(memory, size);
}
}

bool fuzz::AllocationWatch::works() { return true; }

#else

bool fuzz::AllocationWatch::works() { return false; }

#endif

namespace fuzz {

AllocationWatch::AllocationWatch()
{
    t_largest = 0;
    t_watching = true;
}

AllocationWatch::~AllocationWatch() { t_watching = false; }

std::size_t AllocationWatch::largest() const { return t_largest; }

} // namespace fuzz
