#include "row_menus.h"

#include "settings_model.h"
#include "theme.h"

#include <QApplication>
#include <QClipboard>
#include <QMenu>

namespace lds::ui {

RowMenus::RowMenus(SettingsModel& model)
    : m_model(model)
{}

void RowMenus::addOrders(QMenu& menu, const SettingRow& row)
{
    const auto& session = *m_model.session();
    const RowFacts facts(row, session);
    const catalog::SettingItem& item = *row.first();
    const bool usable = facts.isUsable();
    if (!usable && !facts.whyNot().isEmpty()) {
        menu.addAction(facts.whyNot())->setEnabled(false);
        menu.addSeparator();
    }
    for (const auto& order : row.orders(session.model())) {
        const bool isTrigger = item.kind == catalog::Kind::Trigger;
        QString text = isTrigger ? tr("%1: %2").arg(order.text, row.title()) : order.text;
        if (!order.offered)
            text = tr("%1 (starts a procedure; use the sensor's keys)").arg(text);
        QAction* action = menu.addAction(text);
        action->setEnabled(usable && order.offered);
        if (item.isReadable()) {
            action->setCheckable(true);
            action->setChecked(session.held(item.id) == order.value);
        }
        connect(action, &QAction::triggered, this,
                [this, id = item.id, value = order.value] { Q_EMIT commandRequested(id, value); });
    }
}

void RowMenus::popUpOrders(const SettingRow& row, const QPoint& at, QWidget* parent)
{
    if (!m_model.session() || row.orders(m_model.session()->model()).isEmpty())
        return;
    auto* menu = new QMenu(parent);
    menu->setObjectName(QStringLiteral("orders"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setAccessibleName(tr("%1, acts at once").arg(row.title()));
    addOrders(*menu, row);
    menu->popup(at);
}

void RowMenus::addEditing(QMenu& menu, const SettingRow& row)
{
    const RowFacts facts(row, *m_model.session());
    const auto& theme = Theme::instance();
    const SettingRow* subject = &row;
    QAction* edit = menu.addAction(theme.icon(QStringLiteral("edit")), tr("Edit"), this,
                                   [this, subject] { Q_EMIT editRequested(subject); });
    edit->setShortcut(Qt::Key_F2);
    edit->setEnabled(facts.isEditable());
    QAction* back = menu.addAction(theme.icon(QStringLiteral("reset")), tr("Revert the edit"), this,
                                   [this, subject] { revert(*subject); });
    back->setShortcut(Qt::Key_Delete);
    back->setEnabled(facts.isEdited() || !m_model.wrongInput(row).text.isEmpty());
    QString standard = facts.defaultText();
    if (!standard.isEmpty() && !facts.unit().isEmpty())
        standard += QChar(QChar::Nbsp) + facts.unit();
    QAction* toDefault =
        menu.addAction(standard.isEmpty() ? tr("Set to default") : tr("Set to default (%1)").arg(standard),
                       this, [this, subject] { setToDefault(*subject); });
    toDefault->setEnabled(facts.isEditable() && facts.hasDefault());
    if (facts.hasConflict()) {
        menu.addSeparator();
        menu.addAction(tr("Keep mine"), this, [this, subject] { keepMine(*subject); });
        menu.addAction(tr("Take the sensor's"), this, [this, subject] { revert(*subject); });
    }
}

void RowMenus::popUpContext(const SettingRow& row, const QPoint& at, QWidget* parent)
{
    if (!m_model.session())
        return;
    auto* menu = new QMenu(parent);
    menu->setObjectName(QStringLiteral("rowMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const SettingRow* subject = &row;
    if (row.isSetting())
        addEditing(*menu, row);
    else if (row.actsAtOnce())
        addOrders(*menu, row);
    menu->addSeparator();
    const auto& theme = Theme::instance();
    if (!row.isHeading()) {
        menu->addAction(theme.icon(QStringLiteral("copy")), tr("Copy the value"), this,
                        [this, subject] { copyValue(*subject); });
        menu->addAction(tr("Copy the row"), this, [this, subject] { copyRow(*subject); })
            ->setShortcut(QKeySequence::Copy);
    }
    menu->addAction(theme.icon(QStringLiteral("help")), tr("Help"), this, &RowMenus::detailsRequested)
        ->setShortcut(Qt::Key_F1);
    menu->popup(at);
}

void RowMenus::revert(const SettingRow& row)
{
    if (!m_model.session() || row.isHeading())
        return;
    m_model.keepWrongInput(row, {});
    if (RowFacts(row, *m_model.session()).isEdited())
        m_model.session()->revert(row.ids());
}

void RowMenus::keepMine(const SettingRow& row)
{
    if (!m_model.session())
        return;
    for (const auto id : row.ids()) {
        if (const auto edit = m_model.session()->pending().find(id); edit && edit->conflict)
            m_model.session()->keepMine(id);
    }
}

void RowMenus::copyValue(const SettingRow& row) const
{
    if (!m_model.session())
        return;
    const RowFacts facts(row, *m_model.session());
    QString text = row.isSetting() ? facts.wantedText() : facts.heldText();
    if (!text.isEmpty() && !facts.unit().isEmpty())
        text += u' ' + facts.unit();
    QApplication::clipboard()->setText(text);
}

void RowMenus::copyRow(const SettingRow& row) const
{
    QStringList cells;
    for (int column = 0; column < SettingsModel::ColumnCount; ++column)
        cells += m_model.indexOf(&row, column).data().toString();
    QApplication::clipboard()->setText(cells.join(u'\t'));
}

void RowMenus::setToDefault(const SettingRow& row)
{
    if (!m_model.session())
        return;
    m_model.keepWrongInput(row, {});
    m_model.session()->edit(RowFacts(row, *m_model.session()).defaults());
}

} // namespace lds::ui
