#include "connection_url.h"

#include "catalog.h"
#include "serial_choices.h"

#include <QStringList>
#include <QUrl>

#include <algorithm>

namespace lds::ports {

namespace {

using catalog::Catalog;

constexpr QLatin1StringView modbusTcpScheme("modbus-tcp");
constexpr QLatin1StringView modbusRtuScheme("modbus-rtu");
constexpr quint8 defaultUnit = 1;

using Parsed = tl::expected<void, UrlError>;

tl::unexpected<UrlError> wrong(const char* part, QStringView found, const char* expected)
{
    return tl::unexpected(
        UrlError{QString::fromLatin1(part), found.toString(), QString::fromLatin1(expected)});
}

bool isAsciiDigit(QChar character) { return character >= u'0' && character <= u'9'; }

/// Digits only: no sign, no space, nothing that QString::toInt() would let through besides.
std::optional<int> parseNumber(QStringView text)
{
    constexpr qsizetype mostDigits = 5;
    if (text.isEmpty() || text.size() > mostDigits || !std::all_of(text.begin(), text.end(), isAsciiDigit))
        return std::nullopt;
    return text.toInt();
}

bool isHostLabel(QStringView label)
{
    const auto isAllowed = [](QChar c) { return c.isLetterOrNumber() || c == u'-' || c == u'_'; };
    return !label.isEmpty() && label.size() <= 63 && !label.startsWith(u'-') && !label.endsWith(u'-') &&
           std::all_of(label.begin(), label.end(), isAllowed);
}

/// Four numbers up to 255. A leading zero is refused: some programs read it as octal.
bool isIpv4Address(const QList<QStringView>& parts)
{
    return parts.size() == 4 && std::all_of(parts.begin(), parts.end(), [](QStringView part) {
               const std::optional<int> number = parseNumber(part);
               return number && *number <= 255 && (part.size() == 1 || !part.startsWith(u'0'));
           });
}

bool isHostName(QStringView host)
{
    const QList<QStringView> labels = host.split(u'.');
    const QStringView last = labels.last();
    // A name whose last label is a number is an IPv4 address or nothing.
    if (std::all_of(last.begin(), last.end(), isAsciiDigit))
        return isIpv4Address(labels);
    return host.size() <= 253 && std::all_of(labels.begin(), labels.end(), isHostLabel);
}

bool isIpv6Address(QStringView host)
{
    if (!host.contains(u':'))
        return false;
    QUrl probe;
    probe.setHost(u'[' + host.toString() + u']', QUrl::StrictMode);
    return probe.isValid() && !probe.host().isEmpty();
}

Parsed parseHost(QStringView text, ConnectionUrl& url)
{
    constexpr const char* expected = "a host name or an address (an IPv6 address in brackets)";
    const bool inBrackets = text.startsWith(u'[') && text.endsWith(u']');
    const QStringView host = inBrackets ? text.sliced(1, text.size() - 2) : text;
    if (inBrackets ? !isIpv6Address(host) : !isHostName(host))
        return wrong("host", text, expected);
    url.host = host.toString().toLower();
    return {};
}

Parsed parsePort(QStringView text, ConnectionUrl& url)
{
    const std::optional<int> port = parseNumber(text);
    if (!port || *port < 1 || *port > 65535)
        return wrong("port", text, "a number from 1 to 65535");
    url.port = quint16(*port);
    return {};
}

Parsed parseAuthority(QStringView text, ConnectionUrl& url)
{
    if (text.contains(u'@'))
        return wrong("user", text.first(text.indexOf(u'@')), "no user name: the sensor has no accounts");
    const qsizetype colon = text.indexOf(u':', std::max<qsizetype>(0, text.lastIndexOf(u']')));
    if (colon < 0)
        return parseHost(text, url);
    return parseHost(text.first(colon), url).and_then([&] { return parsePort(text.sliced(colon + 1), url); });
}

Parsed parseUnit(QStringView text, ConnectionUrl& url)
{
    const std::optional<int> unit = parseNumber(text);
    if (url.protocol == Protocol::ModbusRtu) { // 0 is the broadcast that nobody answers; the rest reserved
        const catalog::Limits& limits =
            catalog::hlG2(catalog::ItemId::DeviceAddress).limitsFor(catalog::SensorModel::HlG203);
        if (!unit || *unit < limits.minimum || *unit > limits.maximum)
            return wrong("unit", text, "a number from 1 to 247");
    } else if (!unit || *unit > 255) {
        return wrong("unit", text, "a number from 0 to 255");
    }
    url.unit = quint8(*unit);
    return {};
}

Parsed parseBaud(QStringView text, ConnectionUrl& url)
{
    constexpr qsizetype mostDigits = 6;
    const bool isNumber =
        !text.isEmpty() && text.size() <= mostDigits && std::all_of(text.begin(), text.end(), isAsciiDigit);
    const int baud = isNumber ? text.toInt() : 0;
    if (!speedCode(baud)) {
        QStringList speeds;
        for (const int speed : serialSpeeds())
            speeds << QString::number(speed);
        return tl::unexpected(UrlError{QStringLiteral("baud"), text.toString(),
                                       QStringLiteral("one of ") + speeds.join(QStringLiteral(", "))});
    }
    url.serial.baud = baud;
    return {};
}

constexpr struct {
    SerialParity parity;
    QLatin1StringView word;
} parityWords[] = {{SerialParity::None, QLatin1StringView("none")},
                   {SerialParity::Even, QLatin1StringView("even")},
                   {SerialParity::Odd, QLatin1StringView("odd")}};

QLatin1StringView wordOf(SerialParity parity)
{
    return std::ranges::find_if(parityWords, [parity](const auto& entry) { return entry.parity == parity; })
        ->word;
}

Parsed parseParity(QStringView text, ConnectionUrl& url)
{
    for (const auto& [parity, word] : parityWords) {
        if (text == word) {
            url.serial.parity = parity;
            return {};
        }
    }
    return wrong("parity", text, "none, even or odd");
}

Parsed parseSensor(QStringView text, ConnectionUrl& url)
{
    const catalog::ModelDescription* model = Catalog::hlG2().findModel(text);
    if (!model) {
        QStringList names;
        for (const catalog::ModelDescription& known : Catalog::hlG2().models())
            names << QString::fromLatin1(known.typeName);
        return tl::unexpected(UrlError{QStringLiteral("sensor"), text.toString(),
                                       QStringLiteral("one of ") + names.join(QStringLiteral(", "))});
    }
    url.sensor = model->model;
    return {};
}

Parsed parseView(QStringView text, ConnectionUrl& url)
{
    if (text != u"only")
        return wrong("view", text, "only");
    url.viewOnly = true;
    return {};
}

struct Parameter {
    QStringView name;
    QString value;
};

Parameter splitParameter(QStringView text)
{
    const qsizetype equals = text.indexOf(u'=');
    if (equals < 0)
        return {text, {}};
    return {text.first(equals), QUrl::fromPercentEncoding(text.sliced(equals + 1).toUtf8())};
}

Parsed parseParameter(const Parameter& parameter, ConnectionUrl& url)
{
    const auto& [name, value] = parameter;
    if (name == u"sensor")
        return parseSensor(value, url);
    if (name == u"unit")
        return parseUnit(value, url);
    if (name == u"view")
        return parseView(value, url);
    if (url.protocol == Protocol::ModbusTcp)
        return wrong("parameter", name, "sensor, unit or view");
    if (name == u"baud")
        return parseBaud(value, url);
    if (name == u"parity")
        return parseParity(value, url);
    if (name == u"stop")
        return {}; // judged when the parity is known
    return wrong("parameter", name, "baud, parity, stop, unit, sensor or view");
}

/// The parity decides the stop bits (§6.2), wherever it stands in the text.
Parsed checkStop(const QString& text, const SerialSettings& serial)
{
    if (text == QString::number(serial.stopBits()))
        return {};
    return wrong("stop", text,
                 serial.parity == SerialParity::None ? "2: without parity the sensor uses two stop bits"
                                                     : "1: with a parity the sensor uses one stop bit");
}

Parsed parseParameters(QStringView text, ConnectionUrl& url)
{
    QStringList seen;
    std::optional<QString> stop;
    for (const QStringView part : text.split(u'&')) {
        const Parameter parameter = splitParameter(part);
        if (seen.contains(parameter.name))
            return wrong("parameter", parameter.name, "each parameter once");
        seen << parameter.name.toString();
        if (const Parsed parsed = parseParameter(parameter, url); !parsed)
            return parsed;
        if (parameter.name == u"stop")
            stop = parameter.value;
    }
    return stop ? checkStop(*stop, url.serial) : Parsed();
}

/// As it is opened. What separates the parts of a URL is percent-encoded when it stands in a name.
Parsed parseSerialPort(QStringView text, ConnectionUrl& url)
{
    constexpr const char* expected = "the name of a serial port, such as /dev/ttyUSB0 or COM3";
    const QString name = QUrl::fromPercentEncoding(text.toUtf8());
    const bool isPrintable = std::all_of(
        name.begin(), name.end(), [](QChar c) { return c.isPrint() && c != QChar::ReplacementCharacter; });
    // "//host" is what a TCP URL has there.
    if (name.isEmpty() || !isPrintable || name.trimmed() != name ||
        name.startsWith(QLatin1StringView("//")) || name.endsWith(u'/'))
        return wrong("host", text, expected);
    url.host = name;
    return {};
}

QString encodedSerialPort(const QString& name)
{
    return QString::fromLatin1(QUrl::toPercentEncoding(name, "/:\\()+,;!$'*@"));
}

Parsed parseTcp(QStringView rest, ConnectionUrl& url)
{
    if (const qsizetype slash = rest.indexOf(u'/'); slash >= 0) {
        if (rest.size() > slash + 1)
            return wrong("path", rest.sliced(slash), "no path after the port");
        rest = rest.first(slash);
    }
    return parseAuthority(rest, url);
}

/// The protocol and what stands behind its scheme.
tl::expected<std::pair<Protocol, QStringView>, UrlError> splitScheme(QStringView whole)
{
    constexpr const char* expected = "modbus-tcp://HOST[:PORT] or modbus-rtu:PORT";
    const qsizetype colon = whole.indexOf(u':');
    if (colon < 0)
        return wrong("scheme", whole, expected);
    const QStringView scheme = whole.first(colon);
    const QStringView rest = whole.sliced(colon + 1);
    if (scheme.compare(modbusRtuScheme, Qt::CaseInsensitive) == 0)
        return std::pair(Protocol::ModbusRtu, rest);
    if (!rest.startsWith(QLatin1StringView("//")))
        return wrong("scheme", whole, expected);
    if (scheme.compare(modbusTcpScheme, Qt::CaseInsensitive) != 0)
        return wrong("scheme", scheme, "modbus-tcp or modbus-rtu");
    return std::pair(Protocol::ModbusTcp, rest.sliced(2));
}

} // namespace

QString ConnectionUrl::toString() const
{
    QString text;
    QStringList parameters;
    if (protocol == Protocol::ModbusRtu) {
        text = modbusRtuScheme + u':' + encodedSerialPort(host);
        parameters << QStringLiteral("baud=%1").arg(serial.baud)
                   << QStringLiteral("parity=%1").arg(wordOf(serial.parity))
                   << QStringLiteral("stop=%1").arg(serial.stopBits()) << QStringLiteral("unit=%1").arg(unit);
    } else {
        const QString shownHost = host.contains(u':') ? u'[' + host + u']' : host;
        text = QStringLiteral("%1://%2:%3").arg(modbusTcpScheme, shownHost).arg(port);
    }
    if (sensor)
        parameters << QStringLiteral("sensor=") +
                          QString::fromLatin1(Catalog::hlG2().model(*sensor).typeName);
    if (protocol == Protocol::ModbusTcp && unit != defaultUnit)
        parameters << QStringLiteral("unit=%1").arg(unit);
    if (viewOnly)
        parameters << QStringLiteral("view=only");
    if (!parameters.isEmpty())
        text += u'?' + parameters.join(u'&');
    return text;
}

QString ConnectionUrl::place() const
{
    return protocol == Protocol::ModbusTcp ? QStringLiteral("%1:%2").arg(host).arg(port)
                                           : QStringLiteral("%1, unit %2").arg(host).arg(unit);
}

ConnectionUrl ConnectionUrl::peer() const
{
    ConnectionUrl bare = *this;
    bare.sensor.reset();
    bare.viewOnly = false;
    if (protocol == Protocol::ModbusTcp)
        bare.unit = defaultUnit;
    return bare;
}

tl::expected<ConnectionUrl, UrlError> parseConnectionUrl(const QString& text)
{
    const QString trimmed = text.trimmed();
    const auto split = splitScheme(trimmed);
    if (!split)
        return tl::unexpected(split.error());
    ConnectionUrl url;
    url.protocol = split->first;
    QStringView rest = split->second;
    if (const qsizetype hash = rest.indexOf(u'#'); hash >= 0)
        return wrong("fragment", rest.sliced(hash), "nothing after the parameters");
    if (const qsizetype question = rest.indexOf(u'?'); question >= 0) {
        if (const Parsed parsed = parseParameters(rest.sliced(question + 1), url); !parsed)
            return tl::unexpected(parsed.error());
        rest = rest.first(question);
    }
    const Parsed parsed =
        url.protocol == Protocol::ModbusRtu ? parseSerialPort(rest, url) : parseTcp(rest, url);
    if (!parsed)
        return tl::unexpected(parsed.error());
    return url;
}

} // namespace lds::ports
