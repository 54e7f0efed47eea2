// What libc++ and zstd have large answers for, in few bytes: numbers in messages, and zstd's words
// on what is wrong with a frame. With these the module needs nothing of libc++ but its headers.
#include <string>

namespace std {
inline namespace __2 {

string to_string(unsigned long long number) {
    char digits[20];
    int first = 20;
    do digits[--first] = static_cast<char>('0' + number % 10);
    while ((number /= 10) != 0);
    return string(digits + first, static_cast<size_t>(20 - first));
}
string to_string(unsigned long number) {
    return to_string(static_cast<unsigned long long>(number));
}
string to_string(unsigned number) {
    return to_string(static_cast<unsigned long long>(number));
}
string to_string(long long number) {
    const auto size = static_cast<unsigned long long>(number);
    return number < 0 ? "-" + to_string(0 - size) : to_string(size);
}
string to_string(long number) {
    return to_string(static_cast<long long>(number));
}
string to_string(int number) {
    return to_string(static_cast<long long>(number));
}

}  // namespace __2
}  // namespace std
