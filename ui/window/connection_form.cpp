#include "connection_form.h"

#include "catalog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QStyle>
#include <QVBoxLayout>

namespace lds::ui {

using catalog::Catalog;

namespace {
constexpr int defaultPort = 502; ///< §5.2.1
constexpr int toolPort = 49152;  ///< §5.2.1
} // namespace

ConnectionForm::ConnectionForm(QWidget* parent)
    : QWidget(parent)
    , m_type(new QComboBox(this))
    , m_viewOnly(new QCheckBox(tr("&View only: never write to this sensor"), this))
    , m_url(new QLabel(this))
{
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    form->setHorizontalSpacing(12);
    form->setVerticalSpacing(8);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_host = addField(form, tr("&Address"), "host");
    m_host.edit->setPlaceholderText(tr("192.168.1.6, a host name, or a whole URL"));
    m_host.edit->setToolTip(tr("The sensor shows its address in menu 71."));
    m_port = addField(form, tr("&Port"), "port");
    m_port.edit->setText(QString::number(defaultPort));
    m_port.edit->setPlaceholderText(QString::number(defaultPort));

    auto* portHint = new QLabel(
        tr("%1 is the Modbus port (menu 75), %2 the tool port (menu 74).").arg(defaultPort).arg(toolPort),
        this);
    portHint->setProperty("muted", true);
    m_port.edit->parentWidget()->layout()->addWidget(portHint);
    m_type->setObjectName(QStringLiteral("type"));
    m_type->addItem(tr("Find out from what it holds"), -1);
    for (const auto& model : Catalog::hlG2().models())
        m_type->addItem(tr("%1 (%2 mm)").arg(QString::fromLatin1(model.typeName)).arg(model.centerDistance),
                        int(model.model));
    m_type->setAccessibleName(tr("Type"));
    m_type->setToolTip(tr("Modbus does not tell the type; it is printed on the sensor."));
    form->addRow(tr("&Type"), m_type);

    m_name = addField(form, tr("&Name"), "name");
    m_name.edit->setPlaceholderText(tr("What you call it, for example Press 3, left"));
    m_viewOnly->setObjectName(QStringLiteral("viewOnly"));
    form->addRow(QString(), m_viewOnly);
    m_url->setObjectName(QStringLiteral("url"));
    m_url->setProperty("muted", true);
    m_url->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_url->setAccessibleName(tr("The connection as a URL"));
    form->addRow(tr("URL"), m_url);

    setFocusProxy(m_host.edit);
    setTabOrder(m_host.edit, m_port.edit);
    setTabOrder(m_port.edit, m_type);
    setTabOrder(m_type, m_name.edit);
    setTabOrder(m_name.edit, m_viewOnly);
    connect(m_host.edit, &QLineEdit::editingFinished, this, &ConnectionForm::takeWholeUrl);
    for (QLineEdit* edit : {m_host.edit, m_port.edit})
        connect(edit, &QLineEdit::textChanged, this, &ConnectionForm::showUrl);
    connect(m_type, &QComboBox::currentIndexChanged, this, &ConnectionForm::showUrl);
    connect(m_viewOnly, &QCheckBox::toggled, this, &ConnectionForm::showUrl);
    showUrl();
}

ConnectionForm::Field ConnectionForm::addField(QFormLayout* form, const QString& label, const char* name)
{
    auto* column = new QWidget(this);
    auto* layout = new QVBoxLayout(column);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    const Field field{new QLineEdit(column), new QLabel(column)};
    field.edit->setObjectName(QLatin1StringView(name));
    field.edit->setAccessibleName(QString(label).remove(u'&'));
    field.error->setObjectName(QStringLiteral("%1Error").arg(QLatin1StringView(name)));
    field.error->setProperty("error", true);
    field.error->setWordWrap(true);
    field.error->hide();
    layout->addWidget(field.edit);
    layout->addWidget(field.error);
    auto* caption = new QLabel(label, this);
    caption->setBuddy(field.edit);
    form->addRow(caption, column);
    connect(field.edit, &QLineEdit::textEdited, this, [this, field] {
        setError(field, {});
        Q_EMIT edited();
    });
    return field;
}

void ConnectionForm::setError(const Field& field, const QString& sentence)
{
    field.error->setText(sentence);
    field.error->setVisible(!sentence.isEmpty());
    field.edit->setProperty("invalid", !sentence.isEmpty());
    field.edit->style()->unpolish(field.edit);
    field.edit->style()->polish(field.edit);
    field.edit->setAccessibleDescription(sentence);
}

void ConnectionForm::takeWholeUrl()
{
    const QString text = m_host.edit->text();
    if (!text.contains(QStringLiteral("://")))
        return;
    if (const auto parsed = ports::parseConnectionUrl(text))
        fill({*parsed, name()});
}

QString ConnectionForm::hostError() const
{
    const QString host = m_host.edit->text().trimmed();
    if (host.isEmpty())
        return tr("Enter the sensor's address; its display shows it in menu 71.");
    ports::ConnectionUrl probe;
    probe.host = host;
    const auto parsed =
        ports::parseConnectionUrl(host.contains(QStringLiteral("://")) ? host : probe.toString());
    if (parsed)
        return {};
    return host.contains(QStringLiteral("://"))
               ? tr("This URL cannot be read at “%1”. A URL looks like modbus-tcp://192.168.1.6:502.")
                     .arg(parsed.error().found)
               : tr("“%1” is neither an IP address nor a host name.").arg(host);
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

ports::ConnectionUrl ConnectionForm::url() const
{
    ports::ConnectionUrl url;
    url.host = m_host.edit->text().trimmed();
    url.port = quint16(m_port.edit->text().trimmed().toUInt());
    url.viewOnly = m_viewOnly->isChecked();
    if (const int type = m_type->currentData().toInt(); type >= 0)
        url.sensor = catalog::SensorModel(type);
    return url;
}

std::optional<ports::ConnectionUrl> ConnectionForm::check()
{
    takeWholeUrl();
    setError(m_port, portError());
    setError(m_host, hostError());
    for (const Field& field : {m_host, m_port}) {
        if (!field.error->text().isEmpty()) {
            field.edit->setFocus();
            field.edit->selectAll();
            return std::nullopt;
        }
    }
    const auto parsed = ports::parseConnectionUrl(url().toString()); // as every other door reads it
    return parsed ? std::optional(*parsed) : std::nullopt;
}

QString ConnectionForm::name() const { return m_name.edit->text().trimmed(); }

void ConnectionForm::fill(const RecentConnection& connection)
{
    m_host.edit->setText(connection.url.host);
    m_port.edit->setText(QString::number(connection.url.port));
    m_name.edit->setText(connection.name);
    m_viewOnly->setChecked(connection.url.viewOnly);
    const int type = connection.url.sensor ? int(*connection.url.sensor) : -1;
    m_type->setCurrentIndex(qMax(0, m_type->findData(type)));
    setError(m_host, {});
    setError(m_port, {});
}

void ConnectionForm::showUrl()
{
    const bool isWhole = hostError().isEmpty() && portError().isEmpty();
    m_url->setText(isWhole ? url().toString() : QStringLiteral("\u2013"));
}

} // namespace lds::ui
