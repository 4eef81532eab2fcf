// SPDX-License-Identifier: GPL-3.0-or-later
// Serial lines, UDP and TCP, by Asio. Everything runs on the thread that calls `receive`.
#include "hardware/visca/link.h"

#include <algorithm>
#include <array>
#include <asio.hpp>
#include <atomic>
#include <chrono>
#include <optional>
#include <utility>

namespace kambara::visca {
namespace {

constexpr std::chrono::milliseconds connect_patience{1000};
// What waits to be sent: more means that the other end does not take it.
constexpr std::size_t most_unsent_bytes = 1024;
constexpr int sony_port = 52381;

Error cant_open(const std::string& name, const std::error_code& code) {
    return {"The line to the head (" + name + ") can't be opened (" + code.message() + ").",
            "Check that it is plugged in and switched on, its name, and the right to use it."};
}

Error lost(const std::string& name, const std::string& why) {
    return {"The line to the head (" + name + ") was lost (" + why + ").",
            "Plug it in again; it is tried on and on."};
}

// What every way has in common: waiting, waking, and what came.
class AsioLink : public Link {
  public:
    AsioLink(std::string name, const Clock& clock) : name_(std::move(name)), clock_(clock) {}

    std::string name() const override { return name_; }

    Result<std::vector<Bytes>> receive(std::int64_t until_ns) override {
        // At least what is ready now is taken, however late it is.
        const std::chrono::nanoseconds left{std::max<std::int64_t>(0, until_ns - clock_.now_ns())};
        const auto until = std::chrono::steady_clock::now() + left;
        io_.restart();
        io_.poll();
        while (came_.empty() && !failure_ && !woken_.exchange(false) &&
               std::chrono::steady_clock::now() < until) {
            io_.restart();
            io_.run_one_until(until);
        }
        if (failure_) {
            return lost(name_, std::exchange(failure_, std::nullopt)->message());
        }
        return std::exchange(came_, {});
    }

    void wake() override {
        woken_ = true;
        asio::post(io_, [] {});
    }

  protected:
    void fail(const std::error_code& code) {
        if (code != asio::error::operation_aborted) {
            failure_ = code;
        }
    }
    void forget() {
        came_.clear();
        failure_.reset();
    }
    // Lets what was cancelled end, so that its handlers do not touch what is opened next.
    void run_out() {
        io_.restart();
        io_.poll();
        forget();
    }

    const std::string name_;
    const Clock& clock_;
    asio::io_context io_;
    // So that there is always something to wait for.
    asio::executor_work_guard<asio::io_context::executor_type> work_ = asio::make_work_guard(io_);
    std::vector<Bytes> came_;
    std::optional<std::error_code> failure_;
    std::array<std::uint8_t, 512> buffer_{};

  private:
    std::atomic<bool> woken_ = false;
};

// A serial port or a TCP socket.
template <class Stream>
class StreamLink : public AsioLink {
  public:
    StreamLink(std::string name, const Clock& clock)
        : AsioLink(std::move(name), clock), stream_(io_) {}
    ~StreamLink() override { close_stream(); }

    void close() override { close_stream(); }

    Result<Done> send(const Bytes& packet) override {
        if (unsent_.size() + packet.size() > most_unsent_bytes) {
            return lost(name_, "it takes nothing any more");
        }
        unsent_.insert(unsent_.end(), packet.begin(), packet.end());
        if (under_way_.empty()) {
            write_on();
        }
        return Done{};
    }

  protected:
    void begin() {
        unsent_.clear();
        under_way_.clear();
        read_on();
    }
    void close_stream() {
        std::error_code ignored;
        stream_.close(ignored);
        run_out();
    }

    Stream stream_;

  private:
    void read_on() {
        stream_.async_read_some(asio::buffer(buffer_),
                                [this](const std::error_code& code, std::size_t size) {
                                    if (code) {
                                        fail(code);
                                        return;
                                    }
                                    came_.emplace_back(buffer_.begin(), buffer_.begin() + size);
                                    read_on();
                                });
    }
    void write_on() {
        std::swap(under_way_, unsent_);
        asio::async_write(stream_, asio::buffer(under_way_),
                          [this](const std::error_code& code, std::size_t) {
                              under_way_.clear();
                              if (code) {
                                  fail(code);
                              } else if (!unsent_.empty()) {
                                  write_on();
                              }
                          });
    }

    Bytes unsent_;
    Bytes under_way_;
};

class SerialLink final : public StreamLink<asio::serial_port> {
  public:
    SerialLink(const HeadUri& uri, const Clock& clock)
        : StreamLink(uri.text, clock), device_(uri.device), baud_(uri.baud) {}

    Result<Done> open() override {
        using port = asio::serial_port_base;
        std::error_code code;
        stream_.open(device_, code);
        if (!code) {
            // 8 data bits, no parity, one stop bit, no flow control.
            stream_.set_option(port::baud_rate(static_cast<unsigned>(baud_)), code);
            std::error_code ignored;
            stream_.set_option(port::character_size(8), ignored);
            stream_.set_option(port::parity(port::parity::none), ignored);
            stream_.set_option(port::stop_bits(port::stop_bits::one), ignored);
            stream_.set_option(port::flow_control(port::flow_control::none), ignored);
        }
        if (code) {
            close_stream();
            return cant_open(name_, code);
        }
        begin();
        return Done{};
    }

  private:
    const std::string device_;
    const int baud_;
};

class TcpLink final : public StreamLink<asio::ip::tcp::socket> {
  public:
    TcpLink(const HeadUri& uri, const Clock& clock)
        : StreamLink(uri.text, clock), host_(uri.host), port_(uri.port) {}

    Result<Done> open() override {
        std::error_code code;
        asio::ip::tcp::resolver resolver(io_);
        const auto ends = resolver.resolve(host_, std::to_string(port_), code);
        if (code) {
            return cant_open(name_, code);
        }
        std::optional<std::error_code> connected;
        asio::async_connect(
            stream_, ends,
            [&connected](const std::error_code& result, const auto&) { connected = result; });
        const auto until = std::chrono::steady_clock::now() + connect_patience;
        while (!connected && std::chrono::steady_clock::now() < until) {
            io_.restart();
            io_.run_one_until(until);
        }
        if (!connected) {
            std::error_code ignored;
            stream_.close(ignored);
            while (!connected) {  // its handler knows this place
                io_.restart();
                io_.run_one();
            }
            connected = std::make_error_code(std::errc::timed_out);
        }
        if (*connected) {
            close_stream();
            return cant_open(name_, *connected);
        }
        stream_.set_option(asio::ip::tcp::no_delay(true), code);
        begin();
        return Done{};
    }

  private:
    const std::string host_;
    const int port_;
};

class UdpLink final : public AsioLink {
  public:
    UdpLink(const HeadUri& uri, const Clock& clock)
        : AsioLink(uri.text, clock),
          host_(uri.host),
          port_(uri.port),
          answered_at_sony_port_(uri.wiring == Wiring::udp_sony),
          socket_(io_) {}
    ~UdpLink() override { close_socket(); }

    Result<Done> open() override {
        std::error_code code;
        asio::ip::udp::resolver resolver(io_);
        const auto ends = resolver.resolve(host_, std::to_string(port_), code);
        if (code || ends.empty()) {
            return cant_open(name_, code);
        }
        camera_ = ends.begin()->endpoint();
        socket_.open(camera_.protocol(), code);
        if (code) {
            return cant_open(name_, code);
        }
        // Sony's cameras answer to this port wherever they were asked from, others to where they
        // were asked from. With one port both arrive; where it is taken, only the others are heard.
        if (answered_at_sony_port_ && !(port_ == sony_port && camera_.address().is_loopback())) {
            socket_.bind({camera_.protocol(), sony_port}, code);
        }
        if (!answered_at_sony_port_ || code || socket_.local_endpoint(code).port() == 0) {
            std::error_code ignored;
            socket_.bind({camera_.protocol(), 0}, ignored);
        }
        read_on();
        return Done{};
    }
    void close() override { close_socket(); }

    Result<Done> send(const Bytes& packet) override {
        std::error_code code;
        socket_.send_to(asio::buffer(packet), camera_, 0, code);
        if (code && code != asio::error::would_block) {
            return lost(name_, code.message());
        }
        return Done{};
    }

  private:
    void close_socket() {
        std::error_code ignored;
        socket_.close(ignored);
        run_out();
    }
    void read_on() {
        socket_.async_receive_from(
            asio::buffer(buffer_), from_, [this](const std::error_code& code, std::size_t size) {
                if (code == asio::error::operation_aborted) {
                    return;
                }
                // A camera that is switched off refuses; it is asked again until it is there.
                if (!code && from_.address() == camera_.address()) {
                    came_.emplace_back(buffer_.begin(), buffer_.begin() + size);
                }
                read_on();
            });
    }

    const std::string host_;
    const int port_;
    const bool answered_at_sony_port_;
    asio::ip::udp::socket socket_;
    asio::ip::udp::endpoint camera_;
    asio::ip::udp::endpoint from_;
};

}  // namespace

std::unique_ptr<Link> make_link(const HeadUri& uri, const Clock& clock) {
    switch (uri.wiring) {
        case Wiring::serial:
            return std::make_unique<SerialLink>(uri, clock);
        case Wiring::tcp:
            return std::make_unique<TcpLink>(uri, clock);
        default:
            return std::make_unique<UdpLink>(uri, clock);
    }
}

}  // namespace kambara::visca
