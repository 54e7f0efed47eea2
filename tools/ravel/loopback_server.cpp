#include "ravel/loopback_server.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <thread>

#include <fmt/format.h>

namespace ravel::tool {
namespace {

constexpr std::size_t kLongestRequest = 16 * 1024;
constexpr int kMostConnections = 32;

class Socket {
  public:
    explicit Socket(int number) : number_(number) {}
    Socket(Socket&& other) noexcept : number_(other.number_) { other.number_ = -1; }
    Socket(const Socket&) = delete;
    Socket& operator=(const Socket&) = delete;
    Socket& operator=(Socket&&) = delete;
    ~Socket() {
        if (number_ >= 0) ::close(number_);
    }
    int number() const { return number_; }

  private:
    int number_;
};

Error failure(const char* what) {
    return {Code::unwritable, 0, std::string(what) + ": " + std::strerror(errno)};
}

void send_all(const Socket& to, std::span<const char> bytes) {
    while (!bytes.empty()) {
        const ssize_t sent = ::send(to.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent <= 0) return;
        bytes = bytes.subspan(static_cast<std::size_t>(sent));
    }
}

// The request up to its empty line; empty where the browser said nothing or too much.
std::string read_request(const Socket& from) {
    std::string text;
    std::array<char, 2048> piece;
    while (text.find("\r\n\r\n") == std::string::npos) {
        const ssize_t got = ::recv(from.number(), piece.data(), piece.size(), 0);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0 || text.size() > kLongestRequest) return {};
        text.append(piece.data(), static_cast<std::size_t>(got));
    }
    return text;
}

// The value of the header `Host`. A page of another site may bend a name of its own to this
// address; its requests carry that name.
std::string host_of(std::string_view request) {
    while (true) {
        const std::size_t end = request.find("\r\n");
        if (end == std::string_view::npos || end + 2 >= request.size()) return {};
        request.remove_prefix(end + 2);
        std::string line(request.substr(0, request.find("\r\n")));
        std::transform(line.begin(), line.end(), line.begin(),
                       [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        if (line.rfind("host:", 0) != 0) continue;
        line.erase(0, 5);
        line.erase(0, line.find_first_not_of(" \t"));
        line.erase(line.find_last_not_of(" \t") + 1);
        return line;
    }
}

void answer(const Socket& to, std::string_view request,
            const std::map<std::string, Document>& documents, std::uint16_t port) {
    const std::string_view line = request.substr(0, request.find("\r\n"));
    const std::string_view method = line.substr(0, line.find(' '));
    std::string_view path = line.substr(std::min(line.size(), method.size() + 1));
    path = path.substr(0, path.find_first_of(" ?"));
    const std::string host = host_of(request);
    const bool ours =
        host == fmt::format("127.0.0.1:{}", port) || host == fmt::format("localhost:{}", port);
    const auto found = documents.find(std::string(path));
    const char* status = !ours                                 ? "421 Misdirected Request"
                         : method != "GET" && method != "HEAD" ? "405 Method Not Allowed"
                         : found == documents.end()            ? "404 Not Found"
                                                               : "200 OK";
    const bool good = std::string_view(status) == "200 OK";
    const std::string head = fmt::format(
        "HTTP/1.1 {}\r\nContent-Type: {}\r\nContent-Length: {}\r\n{}Cache-Control: no-store\r\n"
        "X-Content-Type-Options: nosniff\r\nCross-Origin-Resource-Policy: same-origin\r\n"
        "Connection: close\r\n\r\n",
        status, good ? found->second.type : "text/plain", good ? found->second.bytes.size() : 0,
        std::string_view(status).starts_with("405") ? "Allow: GET, HEAD\r\n" : "");
    send_all(to, head);
    if (good && method == "GET") send_all(to, found->second.bytes);
}

}  // namespace

Error serve_on_loopback(const std::map<std::string, Document>& documents, std::uint16_t port,
                        const std::function<void(std::uint16_t)>& ready) {
    const Socket listener(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
    if (listener.number() < 0) return failure("no socket is to be had");
    const int yes = 1;
    ::setsockopt(listener.number(), SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(port);
    socklen_t size = sizeof address;
    auto* const plain = reinterpret_cast<sockaddr*>(&address);
    if (::bind(listener.number(), plain, size) != 0 || ::listen(listener.number(), 16) != 0 ||
        ::getsockname(listener.number(), plain, &size) != 0)
        return failure(fmt::format("port {} can't be listened on", port).c_str());
    const std::uint16_t taken = ntohs(address.sin_port);
    ready(taken);
    // Browsers open connections ahead of need and say nothing on them for a while: each has a
    // thread.
    std::atomic<int> connections = 0;
    while (true) {
        Socket browser(::accept4(listener.number(), nullptr, nullptr, SOCK_CLOEXEC));
        if (browser.number() < 0) {
            if (errno == EINTR || errno == ECONNABORTED) continue;
            return failure("the server stopped");
        }
        if (connections >= kMostConnections) continue;
        const timeval patience{20, 0};
        ::setsockopt(browser.number(), SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
        ::setsockopt(browser.number(), SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
        ++connections;
        std::thread([&documents, &connections, taken, socket = std::move(browser)] {
            const std::string request = read_request(socket);
            if (!request.empty()) answer(socket, request, documents, taken);
            --connections;
        }).detach();
    }
}

}  // namespace ravel::tool
