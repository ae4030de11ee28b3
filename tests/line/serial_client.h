#pragma once

#include "catalog.h"
#include "serial_codes.h"

#include <array>
#include <fcntl.h>
#include <QByteArray>
#include <QFile>
#include <QString>
#include <termios.h>
#include <unistd.h>

namespace lds::test {

/// A program at the other end of a serial line, as the system's calls have it.
class SerialClient {
public:
    explicit SerialClient(const QString& path)
        : m_descriptor(::open(QFile::encodeName(path).constData(), O_RDWR | O_NOCTTY | O_NONBLOCK))
    {}
    ~SerialClient()
    {
        if (isOpen())
            ::close(m_descriptor);
    }
    SerialClient(const SerialClient&) = delete;
    SerialClient& operator=(const SerialClient&) = delete;

    bool isOpen() const { return m_descriptor >= 0; }
    /// As serial port libraries do; false when the system refuses it.
    bool configure(speed_t speed, catalog::LineParity parity)
    {
        termios settings = {};
        ::tcgetattr(m_descriptor, &settings);
        settings.c_cflag &= ~tcflag_t(PARENB | PARODD | CSTOPB);
        settings.c_cflag |= CLOCAL | CREAD;
        if (parity == catalog::LineParity::None)
            settings.c_cflag |= CSTOPB;
        else
            settings.c_cflag |= PARENB;
        if (parity == catalog::LineParity::Odd)
            settings.c_cflag |= PARODD;
        ::cfsetspeed(&settings, speed);
        return ::tcsetattr(m_descriptor, TCSANOW, &settings) == 0;
    }
    bool send(const QByteArray& bytes)
    {
        return ::write(m_descriptor, bytes.constData(), std::size_t(bytes.size())) == bytes.size();
    }
    /// What has arrived since the last time.
    QByteArray take()
    {
        std::array<char, 4096> buffer = {};
        const auto count = ::read(m_descriptor, buffer.data(), buffer.size());
        return count > 0 ? QByteArray(buffer.data(), count) : QByteArray();
    }
    int descriptor() const { return m_descriptor; }

private:
    int m_descriptor;
};

} // namespace lds::test
