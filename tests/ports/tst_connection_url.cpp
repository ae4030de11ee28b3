#include "connection_url.h"

#include "serial_choices.h"

#include <QtTest>

#include <random>

using namespace lds::ports;
using lds::catalog::SensorModel;

class ConnectionUrlTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void textBecomesTheCanonicalText_data();
    void textBecomesTheCanonicalText();
    void everyPartIsRead();
    void whatIsNotThereHasItsDefault();
    void anErrorNamesThePartAtFault_data();
    void anErrorNamesThePartAtFault();
    void whatIsWrittenIsReadBack();
    void garbageIsNeverAccepted();
    void aPlaceSaysWhereTheSensorIs();
};

void ConnectionUrlTest::textBecomesTheCanonicalText_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("canonical");

    const auto row = [](const char* name, const char* text, const char* canonical) {
        QTest::newRow(name) << QString::fromUtf8(text) << QString::fromUtf8(canonical);
    };
    row("address and port", "modbus-tcp://192.168.1.6:49152", "modbus-tcp://192.168.1.6:49152");
    row("§5.2.1 port 502 when none is named", "modbus-tcp://192.168.1.6", "modbus-tcp://192.168.1.6:502");
    row("name", "modbus-tcp://press-3.plant.example:502", "modbus-tcp://press-3.plant.example:502");
    row("short name with underscore", "modbus-tcp://PRESS_3", "modbus-tcp://press_3:502");
    row("slash at the end", "modbus-tcp://localhost:1502/", "modbus-tcp://localhost:1502");
    row("space around", "  modbus-tcp://localhost \n", "modbus-tcp://localhost:502");
    row("scheme in capitals", "MODBUS-TCP://localhost", "modbus-tcp://localhost:502");
    row("IPv6", "modbus-tcp://[fe80::1]:1502", "modbus-tcp://[fe80::1]:1502");
    row("IPv6 without port", "modbus-tcp://[::1]", "modbus-tcp://[::1]:502");
    row("all parameters, in their order", "modbus-tcp://a:1?view=only&unit=7&sensor=hl-g203b-s-mk",
        "modbus-tcp://a:1?sensor=HL-G203B-S-MK&unit=7&view=only");
    row("default unit is left out", "modbus-tcp://a:1?unit=1", "modbus-tcp://a:1");
    row("percent-encoded", "modbus-tcp://a:1?sensor=HL%2DG225B-S-MK",
        "modbus-tcp://a:1?sensor=HL-G225B-S-MK");
    row("§6.2 a serial port has the settings as delivered", "modbus-rtu:/dev/ttyUSB0",
        "modbus-rtu:/dev/ttyUSB0?baud=38400&parity=even&stop=1&unit=1");
    row("COM port", "modbus-rtu:COM3?unit=247", "modbus-rtu:COM3?baud=38400&parity=even&stop=1&unit=247");
    row("no parity makes two stop bits", "modbus-rtu:/dev/ttyS0?parity=none&baud=9600",
        "modbus-rtu:/dev/ttyS0?baud=9600&parity=none&stop=2&unit=1");
    row("stop before parity", "Modbus-RTU:/dev/ttyS0?stop=2&parity=none",
        "modbus-rtu:/dev/ttyS0?baud=38400&parity=none&stop=2&unit=1");
    row("RTU, all parameters",
        "modbus-rtu:/dev/pts/7?view=only&sensor=HL-G203B-S-MK&unit=16&stop=1&parity=odd&baud=230400",
        "modbus-rtu:/dev/pts/7?baud=230400&parity=odd&stop=1&unit=16&sensor=HL-G203B-S-MK&view=only");
    row("port name with signs of a URL", "modbus-rtu:/dev/a%3Fb%23c%25%26d",
        "modbus-rtu:/dev/a%3Fb%23c%25%26d?baud=38400&parity=even&stop=1&unit=1");
    row("port name with a colon", "modbus-rtu:/dev/serial/by-path/pci-0000:00:14.0-usb-0:2:1.0-port0",
        "modbus-rtu:/dev/serial/by-path/pci-0000:00:14.0-usb-0:2:1.0-port0"
        "?baud=38400&parity=even&stop=1&unit=1");
}

void ConnectionUrlTest::textBecomesTheCanonicalText()
{
    QFETCH(QString, text);
    const auto url = parseConnectionUrl(text);
    QVERIFY2(url, qPrintable(url ? QString() : url.error().part));
    QTEST(url->toString(), "canonical");
}

void ConnectionUrlTest::everyPartIsRead()
{
    const auto url = parseConnectionUrl(
        QStringLiteral("modbus-tcp://[::1]:49152?sensor=HL-G212B-S-MK&unit=255&view=only"));
    QVERIFY(url);
    QCOMPARE(url->protocol, Protocol::ModbusTcp);
    QCOMPARE(url->host, QStringLiteral("::1"));
    QCOMPARE(url->port, quint16(49'152));
    QCOMPARE(url->unit, quint8(255));
    QVERIFY(url->viewOnly);
    QCOMPARE(url->sensor, std::optional(SensorModel::HlG212));
}

void ConnectionUrlTest::whatIsNotThereHasItsDefault()
{
    const auto url = parseConnectionUrl(QStringLiteral("modbus-tcp://localhost"));
    QVERIFY(url);
    QCOMPARE(url->port, quint16(502));
    QCOMPARE(url->unit, quint8(1));
    QVERIFY(!url->viewOnly);
    QVERIFY(!url->sensor);
}

void ConnectionUrlTest::anErrorNamesThePartAtFault_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("part");
    QTest::addColumn<QString>("found");

    const auto row = [](const char* name, const char* text, const char* part, const char* found) {
        QTest::newRow(name) << QString::fromUtf8(text) << QString::fromLatin1(part)
                            << QString::fromUtf8(found);
    };
    row("nothing", "", "scheme", "");
    row("no scheme", "192.168.1.6:502", "scheme", "192.168.1.6:502");
    row("another scheme", "http://192.168.1.6", "scheme", "http");
    row("a protocol to come", "slmp://192.168.1.6", "scheme", "slmp");
    row("one slash", "modbus-tcp:/192.168.1.6", "scheme", "modbus-tcp:/192.168.1.6");
    row("no host", "modbus-tcp://", "host", "");
    row("no host but a port", "modbus-tcp://:502", "host", "");
    row("space in the host", "modbus-tcp://my sensor", "host", "my sensor");
    row("octet too large", "modbus-tcp://192.168.1.256", "host", "192.168.1.256");
    row("three octets", "modbus-tcp://192.168.1", "host", "192.168.1");
    row("leading zero", "modbus-tcp://192.168.01.6", "host", "192.168.01.6");
    row("number alone", "modbus-tcp://3232235782", "host", "3232235782");
    row("empty label", "modbus-tcp://press..3", "host", "press..3");
    row("hyphen in front", "modbus-tcp://-press", "host", "-press");
    row("IPv6 without brackets", "modbus-tcp://::1", "host", "");
    row("IPv6 that is none", "modbus-tcp://[1::2::3]", "host", "[1::2::3]");
    row("IPv4 in brackets", "modbus-tcp://[192.168.1.6]", "host", "[192.168.1.6]");
    row("bracket left open", "modbus-tcp://[::1", "host", "[");
    row("user name", "modbus-tcp://me@192.168.1.6", "user", "me");
    row("port 0", "modbus-tcp://a:0", "port", "0");
    row("port 65536", "modbus-tcp://a:65536", "port", "65536");
    row("no port behind the colon", "modbus-tcp://a:", "port", "");
    row("port with a sign", "modbus-tcp://a:+502", "port", "+502");
    row("port in words", "modbus-tcp://a:http", "port", "http");
    row("a huge port", "modbus-tcp://a:99999999999999999999", "port", "99999999999999999999");
    row("path", "modbus-tcp://a:502/holding", "path", "/holding");
    row("fragment", "modbus-tcp://a:502#1", "fragment", "#1");
    row("unit too large", "modbus-tcp://a?unit=256", "unit", "256");
    row("negative unit", "modbus-tcp://a?unit=-1", "unit", "-1");
    row("no unit", "modbus-tcp://a?unit=", "unit", "");
    row("no such sensor", "modbus-tcp://a?sensor=HL-G2", "sensor", "HL-G2");
    row("another view", "modbus-tcp://a?view=all", "view", "all");
    row("unknown parameter", "modbus-tcp://a?units=1", "parameter", "units");
    row("parameters are written in lower case", "modbus-tcp://a?Unit=1", "parameter", "Unit");
    row("twice", "modbus-tcp://a?unit=1&unit=2", "parameter", "unit");
    row("empty parameter", "modbus-tcp://a?", "parameter", "");
    row("TCP has no speed", "modbus-tcp://a?baud=9600", "parameter", "baud");
    row("RTU without a port", "modbus-rtu:", "host", "");
    row("RTU with a host", "modbus-rtu://192.168.1.6", "host", "//192.168.1.6");
    row("RTU with a folder", "modbus-rtu:/dev/", "host", "/dev/");
    row("RTU with a space in front", "modbus-rtu: COM3", "host", " COM3");
    row("RTU with a control character", "modbus-rtu:COM3%00", "host", "COM3%00");
    row("a speed the sensor lacks", "modbus-rtu:COM3?baud=57600", "baud", "57600");
    row("a speed with a sign", "modbus-rtu:COM3?baud=+9600", "baud", "+9600");
    row("no speed", "modbus-rtu:COM3?baud=", "baud", "");
    row("a parity the sensor lacks", "modbus-rtu:COM3?parity=mark", "parity", "mark");
    row("two stop bits with a parity", "modbus-rtu:COM3?parity=odd&stop=2", "stop", "2");
    row("two stop bits with the parity as delivered", "modbus-rtu:COM3?stop=2", "stop", "2");
    row("one stop bit without parity", "modbus-rtu:COM3?stop=1&parity=none", "stop", "1");
    row("no stop bits", "modbus-rtu:COM3?stop=", "stop", "");
    row("broadcast is no sensor", "modbus-rtu:COM3?unit=0", "unit", "0");
    row("unit beyond 247", "modbus-rtu:COM3?unit=248", "unit", "248");
    row("RTU fragment", "modbus-rtu:COM3?unit=2#x", "fragment", "#x");
    row("RTU parameter twice", "modbus-rtu:COM3?baud=9600&baud=9600", "parameter", "baud");
    row("RTU unknown parameter", "modbus-rtu:COM3?speed=9600", "parameter", "speed");
}

void ConnectionUrlTest::anErrorNamesThePartAtFault()
{
    QFETCH(QString, text);
    const auto url = parseConnectionUrl(text);
    QVERIFY2(!url, qPrintable(text));
    QTEST(url.error().part, "part");
    QTEST(url.error().found, "found");
    QVERIFY(!url.error().expected.isEmpty());
}

void ConnectionUrlTest::whatIsWrittenIsReadBack()
{
    std::mt19937 random(502);
    const QStringList hosts{QStringLiteral("192.168.1.6"), QStringLiteral("press-3"), QStringLiteral("::1"),
                            QStringLiteral("fe80::20:4aff:fe00:1"), QStringLiteral("a.b.example")};
    const QStringList serialPorts{QStringLiteral("/dev/ttyUSB0"), QStringLiteral("COM12"),
                                  QStringLiteral("/dev/odd name%?#&=[x]"),
                                  QStringLiteral("/dev/\u00e9\u65e5")};
    for (int i = 0; i < 4'000; ++i) {
        ConnectionUrl url;
        if (random() % 2) {
            url.host = hosts[qsizetype(random() % 5)];
            url.port = quint16(1 + random() % 65'535);
            url.unit = quint8(random());
        } else {
            url.protocol = Protocol::ModbusRtu;
            url.host = serialPorts[qsizetype(random() % 4)];
            url.serial = everySerialSettings().at(qsizetype(random() % 15));
            url.unit = quint8(1 + random() % 247);
        }
        url.viewOnly = random() % 2;
        if (random() % 2)
            url.sensor = SensorModel(random() % 5);
        const auto read = parseConnectionUrl(url.toString());
        QVERIFY2(read, qPrintable(url.toString()));
        QCOMPARE(*read, url);
    }
}

/// A good text with a few characters spoiled is refused or means what its canonical text says.
void ConnectionUrlTest::garbageIsNeverAccepted()
{
    const QString goods[] = {
        QStringLiteral("modbus-tcp://[fe80::1]:49152?sensor=HL-G203B-S-MK&unit=1&view=only"),
        QStringLiteral("modbus-rtu:/dev/ttyUSB0?baud=38400&parity=even&stop=1&unit=1&view=only")};
    const QString alphabet = QStringLiteral("[]:/?#&=@%. -_0a9\u00e9\u3000");
    std::mt19937 random(503);
    for (int i = 0; i < 100'000; ++i) {
        QString text = goods[i % 2];
        for (int n = 1 + int(random() % 4); n > 0; --n)
            text[qsizetype(random() % quint32(text.size()))] =
                alphabet[qsizetype(random() % quint32(alphabet.size()))];
        const auto url = parseConnectionUrl(text);
        if (!url)
            continue;
        QVERIFY2(!url->host.isEmpty() && url->unit <= (url->protocol == Protocol::ModbusRtu ? 247 : 255),
                 qPrintable(text));
        const auto again = parseConnectionUrl(url->toString());
        QVERIFY2(again && *again == *url, qPrintable(text));
    }
}

void ConnectionUrlTest::aPlaceSaysWhereTheSensorIs()
{
    const auto tcp = parseConnectionUrl(QStringLiteral("modbus-tcp://a:1502?unit=7&view=only"));
    const auto rtu =
        parseConnectionUrl(QStringLiteral("modbus-rtu:COM3?unit=7&view=only&sensor=HL-G203B-S-MK"));
    QVERIFY(tcp && rtu);
    QCOMPARE(tcp->place(), QStringLiteral("a:1502"));
    QCOMPARE(rtu->place(), QStringLiteral("COM3, unit 7"));
    QCOMPARE(tcp->peer().toString(), QStringLiteral("modbus-tcp://a:1502"));
    QCOMPARE(rtu->peer().toString(), QStringLiteral("modbus-rtu:COM3?baud=38400&parity=even&stop=1&unit=7"));
}

QTEST_APPLESS_MAIN(ConnectionUrlTest)
#include "tst_connection_url.moc"
