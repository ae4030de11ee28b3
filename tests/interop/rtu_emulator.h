#pragma once

#include "emulator_process.h"
#include "modbus_rtu_framing.h"
#include "modbus_tcp_framing.h"
#include "serial_codes.h"

#include <QFile>
#include <QTcpSocket>
#include <QTemporaryDir>
#include <QTest>

namespace lds::test {

/// How a foreign program is told to open the line.
struct LineChoice {
    int speed = 38'400;
    char parity = 'E'; ///< N, E or O.

    int stopBits() const { return parity == 'N' ? 2 : 1; }
    QString parityWord() const
    {
        return parity == 'N'   ? QStringLiteral("none")
               : parity == 'E' ? QStringLiteral("even")
                               : QStringLiteral("odd");
    }
};

/// lds-emulator with one sensor, reached at a pseudo-terminal and, to prepare it, over Modbus TCP.
class RtuEmulator {
public:
    explicit RtuEmulator(const QString& sensor, const QStringList& more = {})
        : m_process(QStringList{QStringLiteral("--sensor"), sensor, QStringLiteral("--modbus-port"),
                                QStringLiteral("0"), QStringLiteral("--rtu"), link()} +
                    more)
    {}

    QString link() const { return m_folder.filePath(QStringLiteral("line")); }
    /// As the ready line names it; empty when it did not get ready.
    QString rtu() const { return m_process.ready().value(QLatin1StringView("rtu")).toString(); }
    QByteArray errors() { return m_process.errors(); }

    /// Other settings take effect: false when the sensor does not take them.
    bool use(const LineChoice& choice)
    {
        using catalog::LineParity;
        const LineParity parity = choice.parity == 'N'   ? LineParity::None
                                  : choice.parity == 'E' ? LineParity::Even
                                                         : LineParity::Odd;
        return write(400167, int(catalog::lineSpeedCode(choice.speed).value_or(-1))) &&
               write(400168, int(catalog::lineParityCode(parity))) && write(400171, 0);
    }
    bool write(int number, int value)
    {
        constexpr int patienceMs = 20'000;
        const int address = number - 400001;
        QByteArray pdu(1, '\x06');
        for (const int word : {address, value})
            pdu.append(char(word >> 8)).append(char(word & 0xff));
        const QByteArray message = modbus::encodeFrame(1, 1, pdu);
        QTcpSocket socket;
        socket.connectToHost(QHostAddress::LocalHost, m_process.modbusPort());
        if (!socket.waitForConnected(patienceMs))
            return false;
        socket.write(message);
        QByteArray answer;
        while (answer.size() < message.size() && socket.waitForReadyRead(patienceMs))
            answer += socket.readAll();
        return answer == message;
    }

private:
    QTemporaryDir m_folder;
    EmulatorProcess m_process;
};

/// The rows of a test that runs at several settings.
inline void lineChoices()
{
    QTest::addColumn<int>("speed");
    QTest::addColumn<char>("parity");
    QTest::newRow("9600 none") << 9600 << 'N';
    QTest::newRow("19200 odd") << 19200 << 'O';
    QTest::newRow("38400 even") << 38400 << 'E';
    QTest::newRow("115200 none") << 115200 << 'N';
    QTest::newRow("230400 even") << 230400 << 'E';
}

/// Two sensors on one line, by a configuration file.
class TwoUnits {
public:
    TwoUnits(int first, int second)
        : m_process({QStringLiteral("--config"), writeConfig(first, second)})
    {}
    QString link() const { return m_folder.filePath(QStringLiteral("line")); }
    QByteArray line() const { return m_process.line(); }
    QByteArray errors() { return m_process.errors(); }

private:
    QString writeConfig(int first, int second) const
    {
        const QString path = m_folder.filePath(QStringLiteral("config.json"));
        QFile file(path);
        if (file.open(QIODevice::WriteOnly)) {
            file.write(QStringLiteral(R"({ "sensors": [
                { "sensor": "HL-G203B-S-MK", "rtu": "line", "unit": %1 },
                { "sensor": "HL-G205B-S-MK", "rtu": "line", "unit": %2, "answeringTimeMs": 3 } ] })")
                           .arg(first)
                           .arg(second)
                           .toUtf8());
        }
        return path;
    }

    QTemporaryDir m_folder;
    EmulatorProcess m_process;
};

} // namespace lds::test
