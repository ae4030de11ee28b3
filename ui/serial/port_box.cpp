#include "port_box.h"

#include <QLineEdit>
#include <QStandardItemModel>

namespace lds::ui {

PortBox::PortBox(const ports::SerialPorts* ports, QWidget* parent)
    : QComboBox(parent)
    , m_ports(ports)
{
    setEditable(true);
    setInsertPolicy(NoInsert);
    setCompleter(nullptr); // it would put another port's name behind what is being typed
    setSizeAdjustPolicy(AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(24);
    lineEdit()->setPlaceholderText(tr("/dev/ttyUSB0, COM3"));
    setAccessibleName(tr("Serial port"));
    setToolTip(tr("Choose a port, or type its name"));
    connect(lineEdit(), &QLineEdit::textEdited, this, &PortBox::edited);
    connect(this, &QComboBox::activated, this, [this](int index) {
        setEditText(itemData(index).toString());
        Q_EMIT edited();
    });
    refresh();
    if (count() > 0 && !itemData(0).isNull())
        setEditText(itemData(0).toString());
}

QString PortBox::port() const { return currentText().trimmed(); }

void PortBox::setPort(const QString& port) { setEditText(port); }

QString PortBox::error() const
{
    return port().isEmpty() ? tr("Choose the port the line is connected to, or type its name.") : QString();
}

void PortBox::refresh()
{
    const QString entered = currentText();
    const QSignalBlocker quiet(this);
    clear();
    if (m_ports) {
        for (const ports::SerialPortDescription& each : m_ports->list())
            addItem(each.description.isEmpty() ? each.name
                                               : tr("%1 \u2013 %2").arg(each.name, each.description),
                    each.name);
    }
    if (count() == 0) {
        addItem(tr("No port found; type its name"));
        if (auto* items = qobject_cast<QStandardItemModel*>(model()))
            items->item(0)->setEnabled(false);
    }
    setCurrentIndex(findData(entered));
    setEditText(entered);
}

void PortBox::showPopup()
{
    refresh();
    QComboBox::showPopup();
}

} // namespace lds::ui
