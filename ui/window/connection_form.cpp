#include "connection_form.h"

#include "catalog.h"
#include "item_text.h"
#include "port_box.h"
#include "serial_texts.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QStyle>
#include <QVBoxLayout>

namespace lds::ui {

using catalog::Catalog;
using catalog::ItemId;

namespace {

constexpr int defaultPort = 502; ///< §5.2.1
constexpr int toolPort = 49152;  ///< §5.2.1
constexpr int mostUnits = 16;    ///< Sensors on one line.

/// Both forms of URL have it behind their scheme; no host or port has.
bool looksLikeUrl(const QString& text)
{
    return text.contains(QStringLiteral("://")) ||
           text.trimmed().startsWith(QStringLiteral("modbus-rtu:"), Qt::CaseInsensitive);
}

QString itemLabel(ItemId item) { return itemName(catalog::hlG2(item)); }

} // namespace

ConnectionForm::ConnectionForm(const ports::SerialPorts* ports, QWidget* parent)
    : QWidget(parent)
    , m_form(new QFormLayout(this))
    , m_ports(ports)
{
    m_form->setContentsMargins(0, 0, 0, 0);
    m_form->setHorizontalSpacing(12);
    m_form->setVerticalSpacing(8);
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    buildKinds();
    buildEthernet();
    buildSerial();
    buildCommon();
    connectFields();
    showKind();
}

void ConnectionForm::buildKinds()
{
    auto* kinds = new QWidget(this);
    auto* row = new QHBoxLayout(kinds);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(16);
    m_ethernet = new QRadioButton(tr("&Ethernet (Modbus TCP)"), kinds);
    m_ethernet->setObjectName(QStringLiteral("kindEthernet"));
    m_ethernet->setChecked(true);
    m_serial = new QRadioButton(tr("RS-4&85 (Modbus RTU)"), kinds);
    m_serial->setObjectName(QStringLiteral("kindSerial"));
    row->addWidget(m_ethernet);
    row->addWidget(m_serial);
    row->addStretch(1);
    m_form->addRow(tr("Over"), kinds);
}

void ConnectionForm::buildEthernet()
{
    m_host = addField(tr("&Address"), "host");
    m_host.edit->setPlaceholderText(tr("192.168.1.6, a host name, or a whole URL"));
    m_host.edit->setToolTip(tr("The sensor shows its address in menu 71."));
    m_port = addField(tr("&Port"), "port");
    m_port.edit->setText(QString::number(defaultPort));
    m_port.edit->setPlaceholderText(QString::number(defaultPort));
    auto* hint = new QLabel(
        tr("%1 is the Modbus port (menu 75), %2 the tool port (menu 74).").arg(defaultPort).arg(toolPort),
        this);
    hint->setProperty("muted", true);
    m_port.column->layout()->addWidget(hint);
}

void ConnectionForm::buildSerial()
{
    m_serialPortColumn = new QWidget(this);
    auto* column = new QVBoxLayout(m_serialPortColumn);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    m_serialPort = new PortBox(m_ports, m_serialPortColumn);
    m_serialPort->setObjectName(QStringLiteral("serialPort"));
    auto* scan = new QPushButton(tr("S&can…"), m_serialPortColumn);
    scan->setObjectName(QStringLiteral("scanButton"));
    scan->setAutoDefault(false);
    scan->setVisible(m_ports != nullptr);
    scan->setToolTip(tr("Finds the sensors on the line when address or settings are not known"));
    row->addWidget(m_serialPort, 1);
    row->addWidget(scan);
    column->addLayout(row);
    m_serialPortError = addError(m_serialPortColumn, "serialPort");
    addRow(tr("&Port"), m_serialPortColumn, m_serialPort);
    connect(scan, &QPushButton::clicked, this, &ConnectionForm::scanRequested);

    m_speed = new QComboBox(this);
    m_speed->setObjectName(QStringLiteral("speed"));
    m_speed->setAccessibleName(itemLabel(ItemId::CommunicationSpeed));
    m_speed->setToolTip(tr("Menu 83 of the sensor."));
    fillSpeeds(m_speed);
    addRow(tr("&Speed"), m_speed, m_speed);
    m_parity = new QComboBox(this);
    m_parity->setObjectName(QStringLiteral("parity"));
    m_parity->setAccessibleName(itemLabel(ItemId::ParityStopBit));
    m_parity->setToolTip(tr("Menu 84 of the sensor."));
    fillParities(m_parity);
    addRow(tr("Parit&y, stop bits"), m_parity, m_parity);
    showSerial({}, m_speed, m_parity);

    m_units = addField(tr("&Device address"), "units");
    m_units.edit->setText(QStringLiteral("1"));
    m_units.edit->setPlaceholderText(tr("1, or 1-4, 7 for several"));
    m_units.edit->setToolTip(tr("Menu 82 of the sensor: 1 to 247. A list such as 1-4, 7 adds several."));
}

void ConnectionForm::buildCommon()
{
    m_type = new QComboBox(this);
    m_type->setObjectName(QStringLiteral("type"));
    m_type->addItem(tr("Find out from what it holds"), -1);
    for (const auto& model : Catalog::hlG2().models())
        m_type->addItem(tr("%1 (%2 mm)").arg(QString::fromLatin1(model.typeName)).arg(model.centerDistance),
                        int(model.model));
    m_type->setAccessibleName(tr("Type"));
    m_type->setToolTip(tr("Modbus does not tell the type; it is printed on the sensor."));
    addRow(tr("&Type"), m_type, m_type);
    m_name = addField(tr("&Name"), "name");
    m_name.edit->setPlaceholderText(tr("What you call it, for example Press 3, left"));
    m_viewOnly = new QCheckBox(tr("&View only: never write to this sensor"), this);
    m_viewOnly->setObjectName(QStringLiteral("viewOnly"));
    m_form->addRow(QString(), m_viewOnly);
    m_url = new QLabel(this);
    m_url->setObjectName(QStringLiteral("url"));
    m_url->setProperty("muted", true);
    m_url->setWordWrap(true); // "and 1 more" goes below rather than out of sight
    m_url->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // a long one makes no wide window
    m_url->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_url->setAccessibleName(tr("The connection as a URL"));
    m_form->addRow(tr("URL"), m_url);
}

void ConnectionForm::connectFields()
{
    connect(m_host.edit, &QLineEdit::editingFinished, this, &ConnectionForm::takeWholeUrl);
    connect(m_serialPort->lineEdit(), &QLineEdit::editingFinished, this, &ConnectionForm::takeWholeUrl);
    connect(m_serialPort, &PortBox::edited, this, [this] {
        setError(m_serialPort, m_serialPortError, {});
        Q_EMIT edited();
    });
    for (const QLineEdit* edit : {m_host.edit, m_port.edit, m_units.edit})
        connect(edit, &QLineEdit::textChanged, this, &ConnectionForm::showUrl);
    connect(m_serialPort, &QComboBox::editTextChanged, this, &ConnectionForm::showUrl);
    for (const QComboBox* box : {m_speed, m_parity, m_type})
        connect(box, &QComboBox::currentIndexChanged, this, &ConnectionForm::showUrl);
    for (const QComboBox* box : {m_speed, m_parity})
        connect(box, &QComboBox::activated, this, &ConnectionForm::edited);
    connect(m_viewOnly, &QCheckBox::toggled, this, &ConnectionForm::showUrl);
    connect(m_serial, &QRadioButton::toggled, this, [this] {
        showKind();
        Q_EMIT edited();
    });
}

ConnectionForm::Field ConnectionForm::addField(const QString& label, const char* name)
{
    auto* column = new QWidget(this);
    auto* layout = new QVBoxLayout(column);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    auto* edit = new QLineEdit(column);
    edit->setObjectName(QLatin1StringView(name));
    edit->setAccessibleName(QString(label).remove(u'&'));
    layout->addWidget(edit);
    const Field field{column, edit, addError(column, name)};
    addRow(label, column, edit);
    connect(edit, &QLineEdit::textEdited, this, [this, field] {
        setError(field.edit, field.error, {});
        Q_EMIT edited();
    });
    return field;
}

/// `field`: the object name of what the error is about.
QLabel* ConnectionForm::addError(QWidget* column, const char* field)
{
    auto* error = new QLabel(column);
    error->setObjectName(QStringLiteral("%1Error").arg(QLatin1StringView(field)));
    error->setProperty("error", true);
    error->setWordWrap(true);
    error->hide();
    column->layout()->addWidget(error);
    return error;
}

void ConnectionForm::addRow(const QString& label, QWidget* field, QWidget* buddy)
{
    auto* caption = new QLabel(label, this);
    caption->setBuddy(buddy);
    m_form->addRow(caption, field);
}

bool ConnectionForm::isSerial() const { return m_serial->isChecked(); }

void ConnectionForm::showKind()
{
    for (QWidget* field : {m_host.column, m_port.column})
        m_form->setRowVisible(field, !isSerial());
    for (QWidget* field : {m_serialPortColumn, static_cast<QWidget*>(m_speed),
                           static_cast<QWidget*>(m_parity), m_units.column})
        m_form->setRowVisible(field, isSerial());
    setFocusProxy(isSerial() ? static_cast<QWidget*>(m_serialPort) : m_host.edit);
    showUrl();
}

void ConnectionForm::setError(QWidget* edit, QLabel* label, const QString& sentence)
{
    label->setText(sentence);
    label->setVisible(!sentence.isEmpty());
    edit->setProperty("invalid", !sentence.isEmpty());
    edit->style()->unpolish(edit);
    edit->style()->polish(edit);
    edit->setAccessibleDescription(sentence);
}

void ConnectionForm::takeWholeUrl()
{
    const QString text = isSerial() ? m_serialPort->port() : m_host.edit->text();
    if (!looksLikeUrl(text))
        return;
    const auto parsed = ports::parseConnectionUrl(text);
    if (!parsed)
        return;
    // The field the URL was put into belongs to its own kind again.
    const bool toOtherKind = (parsed->protocol == ports::Protocol::ModbusRtu) != isSerial();
    if (toOtherKind && isSerial())
        m_serialPort->setPort({});
    else if (toOtherKind)
        m_host.edit->clear();
    fill({*parsed, name()});
}

QString ConnectionForm::urlError(const QString& text) const
{
    const auto parsed = ports::parseConnectionUrl(text);
    if (parsed)
        return {};
    const QString example = isSerial()
                                ? QStringLiteral("modbus-rtu:/dev/ttyUSB0?baud=38400&parity=even&unit=1")
                                : QStringLiteral("modbus-tcp://192.168.1.6:502");
    return tr("This URL cannot be read at “%1”. A URL looks like %2.").arg(parsed.error().found, example);
}

QString ConnectionForm::hostError() const
{
    const QString host = m_host.edit->text().trimmed();
    if (host.isEmpty())
        return tr("Enter the sensor's address; its display shows it in menu 71.");
    if (looksLikeUrl(host))
        return urlError(host);
    ports::ConnectionUrl probe;
    probe.host = host;
    if (ports::parseConnectionUrl(probe.toString()))
        return {};
    return tr("“%1” is neither an IP address nor a host name.").arg(host);
}

QString ConnectionForm::portError() const
{
    bool isNumber = false;
    const int port = m_port.edit->text().trimmed().toInt(&isNumber);
    if (isNumber && port >= 1 && port <= 65535)
        return {};
    return tr("Enter a port from 1 to 65535: %1 for Modbus, %2 for the tool port.")
        .arg(defaultPort)
        .arg(toolPort);
}

QString ConnectionForm::serialPortError() const
{
    const QString port = m_serialPort->port();
    if (port.isEmpty())
        return m_serialPort->error();
    if (looksLikeUrl(port))
        return urlError(port);
    ports::ConnectionUrl probe;
    probe.protocol = ports::Protocol::ModbusRtu;
    probe.host = port;
    return ports::parseConnectionUrl(probe.toString()) ? QString()
                                                       : tr("“%1” cannot be the name of a port.").arg(port);
}

QString ConnectionForm::unitsError() const
{
    const auto units = parseUnits(m_units.edit->text());
    if (!units)
        return tr("Enter an address from 1 to 247 (menu 82), or a list such as 1-4, 7.");
    return units->size() > mostUnits ? tr("At most %1 sensors share a line.").arg(mostUnits) : QString();
}

QList<ports::ConnectionUrl> ConnectionForm::urls() const
{
    ports::ConnectionUrl url;
    url.viewOnly = m_viewOnly->isChecked();
    if (const int type = m_type->currentData().toInt(); type >= 0)
        url.sensor = catalog::SensorModel(type);
    if (!isSerial()) {
        url.host = m_host.edit->text().trimmed();
        url.port = quint16(m_port.edit->text().trimmed().toUInt());
        return {url};
    }
    url.protocol = ports::Protocol::ModbusRtu;
    url.host = m_serialPort->port();
    url.serial = serialOf(m_speed, m_parity);
    QList<ports::ConnectionUrl> all;
    for (const quint8 unit : parseUnits(m_units.edit->text()).value_or(QList<quint8>())) {
        url.unit = unit;
        all.append(url);
    }
    return all;
}

/// Says what is wrong beside each field and goes to the first of them.
bool ConnectionForm::tellErrors()
{
    struct Check {
        QWidget* edit;
        QLabel* error;
        QString sentence;
    };
    const QList<Check> checks = isSerial()
                                    ? QList<Check>{{m_serialPort, m_serialPortError, serialPortError()},
                                                   {m_units.edit, m_units.error, unitsError()}}
                                    : QList<Check>{{m_host.edit, m_host.error, hostError()},
                                                   {m_port.edit, m_port.error, portError()}};
    bool isRight = true;
    for (const Check& check : checks) {
        setError(check.edit, check.error, check.sentence);
        if (isRight && !check.sentence.isEmpty()) {
            check.edit->setFocus();
            if (auto* line = qobject_cast<QLineEdit*>(check.edit))
                line->selectAll();
            isRight = false;
        }
    }
    return !isRight;
}

QList<ports::ConnectionUrl> ConnectionForm::checkAll()
{
    takeWholeUrl();
    if (tellErrors())
        return {};
    QList<ports::ConnectionUrl> checked;
    for (const ports::ConnectionUrl& url : urls()) {
        if (const auto parsed = ports::parseConnectionUrl(url.toString())) // as every other door reads it
            checked.append(*parsed);
    }
    return checked;
}

std::optional<ports::ConnectionUrl> ConnectionForm::check()
{
    const QList<ports::ConnectionUrl> all = checkAll();
    return all.isEmpty() ? std::nullopt : std::optional(all.first());
}

QString ConnectionForm::name() const { return m_name.edit->text().trimmed(); }

QString ConnectionForm::nameFor(const ports::ConnectionUrl& url) const
{
    const bool several = urls().size() > 1;
    return several && !name().isEmpty() ? tr("%1 \u00b7 %2").arg(name()).arg(url.unit) : name();
}

QString ConnectionForm::serialPort() const { return m_serialPort->port(); }

void ConnectionForm::fill(const RecentConnection& connection)
{
    const ports::ConnectionUrl& url = connection.url;
    if (url.protocol == ports::Protocol::ModbusRtu) {
        m_serialPort->setPort(url.host);
        showSerial(url.serial, m_speed, m_parity);
        m_units.edit->setText(QString::number(url.unit));
        m_serial->setChecked(true);
    } else {
        m_host.edit->setText(url.host);
        m_port.edit->setText(QString::number(url.port));
        m_ethernet->setChecked(true);
    }
    m_name.edit->setText(connection.name);
    m_viewOnly->setChecked(url.viewOnly);
    const int type = url.sensor ? int(*url.sensor) : -1;
    m_type->setCurrentIndex(qMax(0, m_type->findData(type)));
    clearErrors();
}

void ConnectionForm::clearErrors()
{
    for (const Field& field : {m_host, m_port, m_units})
        setError(field.edit, field.error, {});
    setError(m_serialPort, m_serialPortError, {});
}

void ConnectionForm::showUrl()
{
    const bool isWhole = isSerial() ? serialPortError().isEmpty() && unitsError().isEmpty()
                                    : hostError().isEmpty() && portError().isEmpty();
    const QList<ports::ConnectionUrl> all = isWhole ? urls() : QList<ports::ConnectionUrl>();
    const QString first = all.isEmpty() ? QStringLiteral("\u2013") : all.first().toString();
    const QString text = all.size() > 1 ? tr("%1 and %2 more").arg(first).arg(all.size() - 1) : first;
    m_url->setText(text);
    m_url->setToolTip(text);
}

} // namespace lds::ui
