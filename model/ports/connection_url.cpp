#include "connection_url.h"

#include "catalog.h"

#include <QStringList>
#include <QUrl>

#include <algorithm>

namespace lds::ports {

namespace {

using catalog::Catalog;

constexpr QLatin1StringView modbusTcpScheme("modbus-tcp");
constexpr quint16 defaultModbusPort = 502;
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
    if (!unit || *unit > 255)
        return wrong("unit", text, "a number from 0 to 255");
    url.unit = quint8(*unit);
    return {};
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

Parsed parseParameter(QStringView text, QStringList& seen, ConnectionUrl& url)
{
    const qsizetype equals = text.indexOf(u'=');
    const QStringView name = equals < 0 ? text : text.first(equals);
    const QString value =
        equals < 0 ? QString() : QUrl::fromPercentEncoding(text.sliced(equals + 1).toUtf8());
    if (seen.contains(name))
        return wrong("parameter", name, "each parameter once");
    seen << name.toString();
    if (name == u"sensor")
        return parseSensor(value, url);
    if (name == u"unit")
        return parseUnit(value, url);
    if (name == u"view")
        return parseView(value, url);
    return wrong("parameter", name, "sensor, unit or view");
}

Parsed parseParameters(QStringView text, ConnectionUrl& url)
{
    QStringList seen;
    for (const QStringView parameter : text.split(u'&')) {
        if (const Parsed parsed = parseParameter(parameter, seen, url); !parsed)
            return parsed;
    }
    return {};
}

} // namespace

QString ConnectionUrl::toString() const
{
    const QString shownHost = host.contains(u':') ? u'[' + host + u']' : host;
    QString text = QStringLiteral("%1://%2:%3").arg(modbusTcpScheme, shownHost).arg(port);
    QStringList parameters;
    if (sensor)
        parameters << QStringLiteral("sensor=") +
                          QString::fromLatin1(Catalog::hlG2().model(*sensor).typeName);
    if (unit != defaultUnit)
        parameters << QStringLiteral("unit=%1").arg(unit);
    if (viewOnly)
        parameters << QStringLiteral("view=only");
    if (!parameters.isEmpty())
        text += u'?' + parameters.join(u'&');
    return text;
}

tl::expected<ConnectionUrl, UrlError> parseConnectionUrl(const QString& text)
{
    const QString trimmed = text.trimmed();
    const QStringView whole(trimmed);
    const qsizetype schemeEnd = whole.indexOf(QLatin1StringView("://"));
    if (schemeEnd < 0)
        return wrong("scheme", whole, "modbus-tcp://HOST[:PORT]");
    const QStringView scheme = whole.first(schemeEnd);
    if (scheme.compare(modbusTcpScheme, Qt::CaseInsensitive) != 0)
        return wrong("scheme", scheme, "modbus-tcp");

    QStringView rest = whole.sliced(schemeEnd + 3);
    if (const qsizetype hash = rest.indexOf(u'#'); hash >= 0)
        return wrong("fragment", rest.sliced(hash), "nothing after the parameters");

    ConnectionUrl url;
    url.port = defaultModbusPort;
    if (const qsizetype question = rest.indexOf(u'?'); question >= 0) {
        if (const Parsed parsed = parseParameters(rest.sliced(question + 1), url); !parsed)
            return tl::unexpected(parsed.error());
        rest = rest.first(question);
    }
    if (const qsizetype slash = rest.indexOf(u'/'); slash >= 0) {
        if (rest.size() > slash + 1)
            return wrong("path", rest.sliced(slash), "no path after the port");
        rest = rest.first(slash);
    }
    if (const Parsed parsed = parseAuthority(rest, url); !parsed)
        return tl::unexpected(parsed.error());
    return url;
}

} // namespace lds::ports
