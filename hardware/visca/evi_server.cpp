// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/visca/evi_server.h"

#include <algorithm>
#include <array>
#include <asio.hpp>
#include <chrono>
#include <map>
#include <utility>

#include "hardware/visca/pseudo_terminal.h"
#include "hardware/visca/sony_end.h"

namespace kambara::visca {
namespace {

using asio::ip::tcp;
using asio::ip::udp;

constexpr std::chrono::milliseconds look_interval{100};
constexpr std::size_t most_unsent_bytes = 4096;
// So many packets whose replies may still come.
constexpr std::size_t most_tags = 4096;

// One client's line to the camera.
struct Channel {
    Channel(const LineFaults& faults, std::int64_t byte_ns, std::int64_t start_ns)
        : to_camera(faults, byte_ns, start_ns), to_client(other(faults), byte_ns, start_ns) {}
    virtual ~Channel() = default;
    virtual void write(const Bytes& bytes) = 0;
    virtual void cut() = 0;

    static LineFaults other(LineFaults faults) {
        faults.seed += 1;
        return faults;
    }

    FaultyLine to_camera;
    FaultyLine to_client;
    PacketReader reader;
    std::uint64_t too_long = 0;
};

// A pseudo-terminal's end or a TCP connection.
template <class Stream>
struct StreamChannel final : Channel, std::enable_shared_from_this<StreamChannel<Stream>> {
    StreamChannel(Stream stream_in, const Clock& clock_in, const LineFaults& faults,
                  std::int64_t byte_ns, std::int64_t start_ns)
        : Channel(faults, byte_ns, start_ns), stream(std::move(stream_in)), clock(clock_in) {}

    void read_on() {
        stream.async_read_some(
            asio::buffer(buffer),
            [self = this->shared_from_this()](const std::error_code& code, std::size_t size) {
                if (code) {
                    self->open = false;
                    return;
                }
                self->to_camera.put({self->buffer.data(), size}, self->clock.now_ns());
                self->read_on();
            });
    }
    void write(const Bytes& bytes) override {
        // Whoever does not read loses.
        if (open && unsent.size() + bytes.size() <= most_unsent_bytes) {
            unsent.insert(unsent.end(), bytes.begin(), bytes.end());
            if (under_way.empty()) {
                write_on();
            }
        }
    }
    void write_on() {
        std::swap(under_way, unsent);
        asio::async_write(stream, asio::buffer(under_way),
                          [self = this->shared_from_this()](const std::error_code& code, auto) {
                              self->under_way.clear();
                              if (!code && !self->unsent.empty()) {
                                  self->write_on();
                              }
                          });
    }
    void cut() override {
        std::error_code ignored;
        stream.close(ignored);
        open = false;
    }

    Stream stream;
    const Clock& clock;
    bool open = true;
    std::array<std::uint8_t, 512> buffer{};
    Bytes unsent;
    Bytes under_way;
};

using PtyChannel = StreamChannel<asio::posix::stream_descriptor>;
using TcpChannel = StreamChannel<tcp::socket>;

// All UDP clients share one socket; where a reply goes is kept with the packet.
struct UdpChannel final : Channel {
    UdpChannel(udp::socket socket_in, const LineFaults& faults, std::int64_t start_ns)
        : Channel(faults, 0, start_ns), socket(std::move(socket_in)) {}
    void write(const Bytes& bytes) override {
        std::error_code ignored;
        if (!bytes.empty() && !order.empty()) {
            socket.send_to(asio::buffer(bytes), order.front(), 0, ignored);
        }
    }
    void cut() override {}

    udp::socket socket;
    SonyEnd sony;
    udp::endpoint from;
    std::array<std::uint8_t, 512> buffer{};
    std::vector<udp::endpoint> order;  // where the packet that is written goes
};

class Server final : public EviServer {
  public:
    Server(const EviServerOptions& options, Clock& clock)
        : options_(options),
          clock_(clock),
          start_ns_(clock.now_ns()),
          camera_(start_ns_, options.camera) {}

    Result<Done> open();
    std::vector<std::string> places() const override;
    int udp_port() const override { return udp_ ? udp_->socket.local_endpoint().port() : 0; }
    int tcp_port() const override { return acceptor_ ? acceptor_->local_endpoint().port() : 0; }
    void run(std::stop_token stop, const std::function<void(const std::string&)>& report,
             bool packets) override;

  private:
    struct Origin {
        std::weak_ptr<Channel> channel;
        bool has_header = false;
        std::uint32_t sequence = 0;
        udp::endpoint from;
    };

    Result<Done> open_pty();
    void accept_on();
    void read_udp_on();
    void pump(std::int64_t now_ns);
    void take_bytes(const std::shared_ptr<Channel>& channel, const Bytes& bytes,
                    std::int64_t now_ns);
    void to_camera(const Bytes& packet, const Origin& origin, std::int64_t now_ns);
    void put_out(const EviSimulator::Output& output);
    void follow_plug(std::int64_t now_ns);
    std::vector<std::shared_ptr<Channel>> channels() const;
    std::int64_t next_ns(std::int64_t not_after_ns) const;
    asio::ip::address address() const {
        return options_.everywhere ? asio::ip::address(asio::ip::address_v4::any())
                                   : asio::ip::address(asio::ip::address_v4::loopback());
    }
    void tell_packet(const char* way, const Bytes& packet) {
        if (packets_ && report_) {
            report_(std::string(way) + hex_from_bytes(packet));
        }
    }

    const EviServerOptions options_;
    Clock& clock_;
    const std::int64_t start_ns_;
    EviSimulator camera_;
    asio::io_context io_;
    asio::executor_work_guard<asio::io_context::executor_type> work_ = asio::make_work_guard(io_);
    std::optional<PseudoTerminal> terminal_;
    std::shared_ptr<PtyChannel> pty_;
    std::shared_ptr<UdpChannel> udp_;
    std::optional<tcp::acceptor> acceptor_;
    std::vector<std::shared_ptr<TcpChannel>> tcp_;
    std::map<EviSimulator::Tag, Origin> origins_;
    EviSimulator::Tag last_tag_ = 0;
    bool plugged_ = true;
    std::function<void(const std::string&)> report_;
    bool packets_ = false;
};

Error port_taken(const char* what, int port, const std::error_code& code) {
    return {std::string("The ") + what + " port " + std::to_string(port) + " can't be opened (" +
                code.message() + ").",
            "Give another one."};
}

Result<Done> Server::open() {
    std::error_code code;
    if (options_.udp_port) {
        udp::socket socket(io_);
        socket.open(udp::v4(), code);
        socket.bind({address(), static_cast<std::uint16_t>(*options_.udp_port)}, code);
        if (code) {
            return port_taken("UDP", *options_.udp_port, code);
        }
        udp_ = std::make_shared<UdpChannel>(std::move(socket), options_.faults, start_ns_);
        read_udp_on();
    }
    if (options_.tcp_port) {
        acceptor_.emplace(io_);
        acceptor_->open(tcp::v4(), code);
        acceptor_->set_option(tcp::acceptor::reuse_address(true), code);
        acceptor_->bind({address(), static_cast<std::uint16_t>(*options_.tcp_port)}, code);
        if (!code) {
            acceptor_->listen(tcp::acceptor::max_listen_connections, code);
        }
        if (code) {
            return port_taken("TCP", *options_.tcp_port, code);
        }
        accept_on();
    }
    return options_.pty.empty() ? Result<Done>(Done{}) : open_pty();
}

Result<Done> Server::open_pty() {
    auto terminal = PseudoTerminal::open(options_.pty);
    if (!terminal) {
        return terminal.error();
    }
    terminal_.emplace(std::move(*terminal));
    pty_ = std::make_shared<PtyChannel>(
        asio::posix::stream_descriptor(io_, terminal_->take_descriptor()), clock_, options_.faults,
        byte_time_ns(options_.baud), start_ns_);
    pty_->read_on();
    return Done{};
}

std::vector<std::string> Server::places() const {
    std::vector<std::string> all;
    if (!options_.pty.empty()) {
        all.push_back("on the pseudo-terminal " + options_.pty);
    }
    if (udp_) {
        all.push_back("on UDP port " + std::to_string(udp_port()));
    }
    if (acceptor_) {
        all.push_back("on TCP port " + std::to_string(tcp_port()));
    }
    return all;
}

void Server::accept_on() {
    acceptor_->async_accept([this](const std::error_code& code, tcp::socket socket) {
        if (code == asio::error::operation_aborted) {
            return;
        }
        if (!code && plugged_) {
            std::error_code ignored;
            socket.set_option(tcp::no_delay(true), ignored);
            tcp_.push_back(std::make_shared<TcpChannel>(std::move(socket), clock_, options_.faults,
                                                        0, start_ns_));
            tcp_.back()->read_on();
        }
        accept_on();
    });
}

void Server::read_udp_on() {
    udp_->socket.async_receive_from(
        asio::buffer(udp_->buffer), udp_->from,
        [this](const std::error_code& code, std::size_t size) {
            if (code == asio::error::operation_aborted) {
                return;
            }
            if (!code && plugged_) {
                // Faults are put on at once: datagrams of several clients do not make one line.
                FaultyLine& line = udp_->to_camera;
                const std::int64_t now_ns = clock_.now_ns();
                line.put({udp_->buffer.data(), size}, now_ns);
                for (const Bytes& bytes : line.take(line.next_ns().value_or(now_ns))) {
                    take_bytes(udp_, bytes, now_ns);
                }
            }
            read_udp_on();
        });
}

std::vector<std::shared_ptr<Channel>> Server::channels() const {
    std::vector<std::shared_ptr<Channel>> all(tcp_.begin(), tcp_.end());
    if (pty_) {
        all.push_back(pty_);
    }
    return all;
}

void Server::to_camera(const Bytes& packet, const Origin& origin, std::int64_t now_ns) {
    tell_packet("> ", packet);
    origins_[++last_tag_] = origin;
    if (origins_.size() > most_tags) {
        origins_.erase(origins_.begin());
    }
    camera_.receive(packet, last_tag_, now_ns);
}

void Server::take_bytes(const std::shared_ptr<Channel>& channel, const Bytes& bytes,
                        std::int64_t now_ns) {
    Origin origin{channel, false, 0, {}};
    Bytes packets = bytes;
    if (udp_ && channel == udp_) {
        origin.from = udp_->from;
        const auto taken = udp_->sony.take(bytes);
        if (taken.answer) {
            udp_->order = {origin.from};
            udp_->write(*taken.answer);
        }
        packets = taken.packet.value_or(Bytes{});
        origin.has_header = taken.has_header;
        origin.sequence = taken.sequence;
        channel->reader.reset();
    }
    for (const Bytes& packet : channel->reader.read(packets)) {
        to_camera(packet, origin, now_ns);
    }
    if (channel->reader.too_long() > channel->too_long) {
        channel->too_long = channel->reader.too_long();
        origins_[++last_tag_] = origin;
        camera_.receive_too_long(last_tag_, now_ns);
    }
}

void Server::put_out(const EviSimulator::Output& output) {
    tell_packet("< ", output.packet);
    const auto found = origins_.find(output.tag);
    const auto channel = found == origins_.end() ? nullptr : found->second.channel.lock();
    if (!channel) {
        return;
    }
    const Origin& origin = found->second;
    if (udp_ && channel == udp_) {
        FaultyLine& line = udp_->to_client;
        line.put(origin.has_header ? SonyEnd::reply(output.packet, origin.sequence) : output.packet,
                 output.time_ns);
        udp_->order = {origin.from};
        for (const Bytes& bytes : line.take(line.next_ns().value_or(output.time_ns))) {
            udp_->write(bytes);
        }
        return;
    }
    channel->to_client.put(output.packet, output.time_ns);
}

void Server::pump(std::int64_t now_ns) {
    for (const auto& channel : channels()) {
        for (const Bytes& bytes : channel->to_camera.take(now_ns)) {
            take_bytes(channel, bytes, now_ns);
        }
    }
    for (const auto& output : camera_.advance(now_ns)) {
        put_out(output);
    }
    for (const auto& channel : channels()) {
        for (const Bytes& bytes : channel->to_client.take(now_ns)) {
            channel->write(bytes);
        }
    }
    std::erase_if(tcp_, [](const auto& channel) { return !channel->open; });
    follow_plug(now_ns);
}

void Server::follow_plug(std::int64_t now_ns) {
    const bool plugged =
        is_plugged(options_.faults, static_cast<double>(now_ns - start_ns_) * 1e-9);
    if (plugged == plugged_) {
        return;
    }
    plugged_ = plugged;
    if (report_) {
        report_(plugged ? "The plug is in." : "The plug is out.");
    }
    if (!plugged) {
        for (const auto& channel : channels()) {
            channel->cut();
        }
        tcp_.clear();
        pty_.reset();
        terminal_.reset();
        return;
    }
    if (!options_.pty.empty()) {
        if (const auto opened = open_pty(); !opened && report_) {
            report_(opened.error().text());
        }
    }
    if (options_.power_goes_too) {
        origins_[++last_tag_] = Origin{pty_, false, 0, {}};
        camera_.power_cycle(last_tag_, now_ns);
    }
}

std::int64_t Server::next_ns(std::int64_t not_after_ns) const {
    std::int64_t next_ns = std::min(not_after_ns, camera_.next_event_ns().value_or(not_after_ns));
    for (const auto& channel : channels()) {
        next_ns = std::min({next_ns, channel->to_camera.next_ns().value_or(not_after_ns),
                            channel->to_client.next_ns().value_or(not_after_ns)});
    }
    return next_ns;
}

void Server::run(std::stop_token stop, const std::function<void(const std::string&)>& report,
                 bool packets) {
    report_ = report;
    packets_ = packets;
    constexpr std::int64_t look_ns = std::chrono::nanoseconds(look_interval).count();
    while (!stop.stop_requested()) {
        const std::int64_t now_ns = clock_.now_ns();
        pump(now_ns);
        const std::int64_t wait_ns = std::max<std::int64_t>(0, next_ns(now_ns + look_ns) - now_ns);
        io_.restart();
        io_.run_one_for(std::chrono::nanoseconds(wait_ns));
        io_.restart();
        io_.poll();
    }
    report_ = nullptr;
}

}  // namespace

Result<std::unique_ptr<EviServer>> EviServer::open(const EviServerOptions& options, Clock& clock) {
    auto server = std::make_unique<Server>(options, clock);
    if (const auto opened = server->open(); !opened) {
        return opened.error();
    }
    return std::unique_ptr<EviServer>(std::move(server));
}

}  // namespace kambara::visca
