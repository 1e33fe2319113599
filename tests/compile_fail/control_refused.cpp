// expect: nodiscard
// The mechanism itself: warnings are errors, and the message is the one expected.
[[nodiscard]] constexpr int answer() noexcept { return 42; }

void use() {
    (void)answer();
    answer();  // wrong
}
