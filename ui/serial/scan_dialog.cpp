#include "scan_dialog.h"

#include "height_keeper.h"
#include "port_box.h"
#include "scan_findings_model.h"
#include "serial_choices.h"
#include "serial_texts.h"
#include "theme.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QRadioButton>
#include <QSpinBox>
#include <QStyle>
#include <QTableView>
#include <QVBoxLayout>

namespace lds::ui {

using ports::ScanEnd;
using ports::ScanFinding;

namespace {

constexpr int lastUnit = 247;
constexpr qint64 nsPerSecond = 1'000'000'000;

void setPrimary(QPushButton* button, bool primary)
{
    button->setProperty("primary", primary);
    button->setDefault(primary);
    button->style()->unpolish(button);
    button->style()->polish(button);
}

} // namespace

ScanDialog::ScanDialog(sensor::Workspace& workspace, const ports::SerialPorts* ports,
                       ports::BusScanFactory& scans, ports::Scheduler& scheduler, QWidget* parent)
    : QDialog(parent)
    , m_workspace(workspace)
    , m_scans(scans)
    , m_scheduler(scheduler)
    , m_findings(new ScanFindingsModel(this))
    , m_port(new PortBox(ports, this))
    , m_portError(new QLabel(this))
    , m_progress(new QProgressBar(this))
    , m_state(new QLabel(this))
{
    setObjectName(QStringLiteral("scanDialog"));
    setWindowTitle(tr("Scan an RS-485 line"));
    setAttribute(Qt::WA_DeleteOnClose);
    resize(860, 560);
    new HeightKeeper(this);

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(20, 16, 20, 16);
    column->setSpacing(12);
    auto* title = new QLabel(tr("Find sensors on an RS-485 line"), this);
    title->setProperty("title", true);
    column->addWidget(title);
    buildFields(column);
    m_progress->setTextVisible(false);
    m_progress->setAccessibleName(tr("Progress of the scan"));
    m_progress->setObjectName(QStringLiteral("scanProgress"));
    m_state->setObjectName(QStringLiteral("scanState"));
    m_state->setWordWrap(true);
    column->addWidget(m_progress);
    column->addWidget(m_state);
    buildFindings(column);
    buildButtons(column);
    setScanning(false);
    m_progress->hide();
    say(tr("Scanning asks one address after the other and writes nothing."));
    m_port->setFocus();
}

ScanDialog::~ScanDialog() = default;

void ScanDialog::buildFields(QVBoxLayout* column)
{
    m_fields = new QWidget(this);
    auto* form = new QFormLayout(m_fields);
    form->setContentsMargins(0, 0, 0, 0);
    form->setHorizontalSpacing(12);
    form->setVerticalSpacing(8);
    form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);

    m_port->setObjectName(QStringLiteral("scanPort"));
    m_portError->setObjectName(QStringLiteral("scanPortError"));
    m_portError->setProperty("error", true);
    m_portError->hide();
    auto* port = new QVBoxLayout;
    port->setSpacing(2);
    port->addWidget(m_port);
    port->addWidget(m_portError);
    auto* portLabel = new QLabel(tr("&Port"), m_fields);
    portLabel->setBuddy(m_port);
    form->addRow(portLabel, port);
    connect(m_port, &QComboBox::editTextChanged, m_portError, &QWidget::hide);

    const QList<ports::SerialSettings> usual = ports::usualSerialSettings();
    m_usual = new QRadioButton(tr("&Usual: %1 as delivered, then the other speeds with %2")
                                   .arg(serialText(usual.first()), parityText(usual.first().parity)),
                               m_fields);
    m_usual->setObjectName(QStringLiteral("usualSettings"));
    m_every = new QRadioButton(
        tr("A&ll %1 combinations of speed and parity").arg(ports::everySerialSettings().size()), m_fields);
    m_every->setObjectName(QStringLiteral("everySettings"));
    m_usual->setChecked(true);
    form->addRow(tr("Settings"), m_usual);
    form->addRow(QString(), m_every);

    auto* range = new QHBoxLayout;
    range->setSpacing(8);
    const auto addUnit = [&](const char* name, int value, const QString& accessibleName) {
        auto* box = new QSpinBox(m_fields);
        box->setObjectName(QLatin1StringView(name));
        box->setRange(1, lastUnit);
        box->setValue(value);
        box->setMinimumWidth(80);
        box->setAccessibleName(accessibleName);
        return box;
    };
    m_first = addUnit("firstUnit", 1, tr("First address"));
    m_last = addUnit("lastUnit", lastUnit, tr("Last address"));
    range->addWidget(m_first);
    range->addWidget(new QLabel(tr("to"), m_fields));
    range->addWidget(m_last);
    range->addStretch(1);
    auto* rangeLabel = new QLabel(tr("&Addresses"), m_fields);
    rangeLabel->setBuddy(m_first);
    form->addRow(rangeLabel, range);
    connect(m_first, &QSpinBox::valueChanged, m_last, &QSpinBox::setMinimum);
    column->addWidget(m_fields);
}

void ScanDialog::buildFindings(QVBoxLayout* column)
{
    m_table = new QTableView(this);
    m_table->setObjectName(QStringLiteral("scanFindings"));
    m_table->setAccessibleName(tr("What was found"));
    m_table->setModel(m_findings);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(28);
    m_table->setShowGrid(false);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setTabKeyNavigation(false);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->setWordWrap(false);
    m_table->setProperty("card", true);
    QHeaderView* header = m_table->horizontalHeader();
    header->setHighlightSections(false);
    header->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    header->setSectionResizeMode(QHeaderView::Interactive);
    header->setSectionResizeMode(ScanFindingsModel::Note, QHeaderView::Stretch);
    m_table->setColumnWidth(ScanFindingsModel::Address, 90);
    m_table->setColumnWidth(ScanFindingsModel::Found, 170);
    m_table->setColumnWidth(ScanFindingsModel::Settings, 210);
    column->addWidget(m_table, 1);
    m_advice = new QLabel(this);
    m_advice->setObjectName(QStringLiteral("scanAdvice"));
    m_advice->setWordWrap(true);
    m_advice->hide();
    column->addWidget(m_advice);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            &ScanDialog::showAdvice);
    connect(m_findings, &ScanFindingsModel::tickedChanged, this, &ScanDialog::showTicked);
}

void ScanDialog::buildButtons(QVBoxLayout* column)
{
    m_startStop = new QPushButton(this);
    m_startStop->setObjectName(QStringLiteral("scanButton"));
    m_add = new QPushButton(this);
    m_add->setObjectName(QStringLiteral("addButton"));
    auto* close = new QPushButton(tr("&Close"), this);
    close->setObjectName(QStringLiteral("closeButton"));
    close->setAutoDefault(false);
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    row->addStretch(1);
    row->addWidget(close);
    row->addWidget(m_add);
    row->addWidget(m_startStop);
    column->addLayout(row);
    connect(m_startStop, &QPushButton::clicked, this, [this] { m_scanning ? stop() : start(); });
    connect(m_add, &QPushButton::clicked, this, &ScanDialog::addTicked);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    showTicked();
}

void ScanDialog::setPort(const QString& port) { m_port->setPort(port); }

void ScanDialog::start()
{
    const QString error = m_port->error();
    m_portError->setText(error);
    m_portError->setVisible(!error.isEmpty());
    if (!error.isEmpty())
        return m_port->setFocus();
    m_findings->clear();
    m_advice->hide();
    m_scannedPort = m_port->port();
    m_startedNs = m_scheduler.nowNs();
    m_scan = m_scans.createScan();
    connect(m_scan.get(), &ports::BusScan::progressed, this, &ScanDialog::progressed, Qt::QueuedConnection);
    connect(m_scan.get(), &ports::BusScan::found, this, &ScanDialog::found, Qt::QueuedConnection);
    connect(m_scan.get(), &ports::BusScan::finished, this, &ScanDialog::finished, Qt::QueuedConnection);
    m_progress->setRange(0, 0);
    setScanning(true);
    say(tr("Opening %1…").arg(m_scannedPort));
    m_scan->start({m_scannedPort,
                   m_usual->isChecked() ? ports::usualSerialSettings() : ports::everySerialSettings(),
                   quint8(m_first->value()), quint8(m_last->value())});
}

void ScanDialog::stop()
{
    m_startStop->setEnabled(false);
    m_scan->cancel();
}

void ScanDialog::progressed(const ports::ScanProgress& progress)
{
    if (!m_scanning)
        return;
    m_progress->setRange(0, progress.total);
    m_progress->setValue(progress.asked);
    const QString now = tr("Asking address %1 with %2").arg(progress.unit).arg(serialText(progress.serial));
    const QString left = timeLeft(progress);
    say(left.isEmpty() ? now : tr("%1 \u00b7 %2").arg(now, left));
}

QString ScanDialog::timeLeft(const ports::ScanProgress& progress) const
{
    constexpr int fewest = 20; // before that it would be a guess
    if (progress.asked < fewest)
        return {};
    const qint64 elapsedNs = m_scheduler.nowNs() - m_startedNs;
    const qint64 seconds = elapsedNs / progress.asked * (progress.total - progress.asked) / nsPerSecond + 1;
    return seconds < 90 ? tr("about %1 s left").arg(seconds)
                        : tr("about %1 min left").arg((seconds + 30) / 60);
}

void ScanDialog::found(const ScanFinding& finding)
{
    m_findings->add(finding, isInList(finding));
    if (!m_table->currentIndex().isValid() && !findingAdvice(finding).isEmpty())
        m_table->selectRow(m_findings->rowCount() - 1);
}

void ScanDialog::finished(ScanEnd end, const QString& detail)
{
    setScanning(false);
    const int count = m_findings->rowCount();
    switch (end) {
    case ScanEnd::PortFailed:
        m_progress->hide();
        say(tr("%1 cannot be used%2. Check that the adapter is plugged in, that no other program has the "
               "port, and that you may use it.")
                .arg(m_scannedPort, detail.isEmpty() ? QString() : tr(": %1").arg(detail)),
            true);
        return m_port->setFocus();
    case ScanEnd::Cancelled:
        say(tr("Stopped. What was found so far is below."));
        break;
    case ScanEnd::Complete:
        say(count > 0 ? tr("Done.")
                      : tr("Nobody answered. Check power and wiring, that A and B are not swapped, and that "
                           "the sensors are on this port; then try all combinations."));
        break;
    }
    m_progress->hide();
    if (!m_add->isHidden())
        m_add->setFocus();
}

void ScanDialog::setScanning(bool scanning)
{
    m_scanning = scanning;
    m_fields->setEnabled(!scanning);
    m_progress->setVisible(scanning);
    m_startStop->setEnabled(true);
    m_startStop->setText(scanning ? tr("&Stop") : tr("&Scan"));
    showTicked();
}

void ScanDialog::say(const QString& sentence, bool isError)
{
    m_state->setProperty("error", isError);
    m_state->style()->unpolish(m_state);
    m_state->style()->polish(m_state);
    m_state->setText(sentence);
}

void ScanDialog::showAdvice()
{
    const int row = m_table->currentIndex().row();
    const QString advice = row >= 0 ? findingAdvice(m_findings->findingAt(row)) : QString();
    m_advice->setText(advice);
    m_advice->setVisible(!advice.isEmpty());
}

void ScanDialog::showTicked()
{
    if (!m_add || !m_startStop)
        return;
    const int count = int(m_findings->ticked().size());
    m_add->setVisible(count > 0);
    m_add->setText(count == 1 ? tr("&Add 1 sensor") : tr("&Add %1 sensors").arg(count));
    const bool canAdd = count > 0 && !m_scanning; // one blue button at a time
    setPrimary(m_add, canAdd);
    setPrimary(m_startStop, !canAdd && !m_scanning);
}

void ScanDialog::addTicked()
{
    const QString port = m_scannedPort;
    const QList<ScanFinding> ticked = m_findings->ticked();
    m_scan.reset(); // gives the port back
    m_scanning = false;
    for (const ScanFinding& finding : ticked) {
        const ports::ConnectionUrl url = urlOf(finding);
        sensor::SensorSession* session = m_workspace.find(url);
        if (!session)
            session = m_workspace.add(url);
        else if (session->url().serial != url.serial)
            session->moveTo(url); // it has other settings than it had
        session->open();
        Q_EMIT sensorAdded(session->url());
    }
    accept();
}

ports::ConnectionUrl ScanDialog::urlOf(const ScanFinding& finding) const
{
    ports::ConnectionUrl url;
    url.protocol = ports::Protocol::ModbusRtu;
    url.host = m_scannedPort;
    url.serial = finding.serial;
    url.unit = finding.unit;
    return url;
}

bool ScanDialog::isInList(const ScanFinding& finding) const
{
    const sensor::SensorSession* session = m_workspace.find(urlOf(finding));
    return session && session->url().serial == finding.serial;
}

void ScanDialog::done(int result)
{
    m_scan.reset();
    QDialog::done(result);
}

} // namespace lds::ui
