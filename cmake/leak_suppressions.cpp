// Suppressions of the known leaks of other libraries for LeakSanitizer. It is linked into
// every program of a build with AddressSanitizer, and the function is weak because libraries that
// are compiled as one file contain it, too.

// CLN never frees the 26 bytes that its static cl_prin_globals_init_helper allocates on loading.
// GiNaC loses a power that it has just allocated when the power divides by zero and throws.
// NOLINTNEXTLINE(bugprone-reserved-identifier): the name that LeakSanitizer looks for
extern "C" [[gnu::weak]] const char* __lsan_default_suppressions() {
  return "leak:libcln.so\n"
         "leak:GiNaC::mul::combine_ex_with_coeff_to_pair\n"
         "leak:GiNaC::power::subs\n";
}

// Tests read what a program prints, so suppressions are not reported.
// NOLINTNEXTLINE(bugprone-reserved-identifier): as above
extern "C" [[gnu::weak]] const char* __lsan_default_options() { return "print_suppressions=0"; }
