/// Linked into programs that write text into images: Fontconfig keeps what it read of fonts, 651 bytes
/// however many images there are, until the process ends, where LeakSanitizer finds nothing that still points
/// to it.

extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig.so"; }
