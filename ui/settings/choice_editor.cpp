#include "choice_editor.h"

#include "item_text.h"
#include "row_facts.h"

namespace lds::ui {

ChoiceEditor::ChoiceEditor(const SettingRow& row, sensor::SensorSession& session, QWidget* parent)
    : QComboBox(parent)
    , RowEditor(row, session)
{
    setAccessibleName(row.title());
    setSizeAdjustPolicy(QComboBox::AdjustToContents);
    const catalog::SettingItem& item = *row.first();
    for (const auto& choice : item.choices) {
        if (choice.models & catalog::maskOf(session.model()))
            addItem(choiceName(choice), choice.code);
    }
    // A code the type does not have stays unselected: it cannot be chosen, and is not silently another.
    const auto wanted = RowFacts(row, session).wanted(item);
    setCurrentIndex(wanted ? findData(*wanted) : -1);
    connect(this, &QComboBox::activated, this, [this] {
        if (m_listOpen)
            Q_EMIT chosen();
    });
}

void ChoiceEditor::commit()
{
    if (session() && currentIndex() >= 0)
        session()->edit({{row().first()->id, currentData().toInt()}});
}

void ChoiceEditor::showPopup()
{
    m_listOpen = true;
    QComboBox::showPopup();
}

void ChoiceEditor::hidePopup()
{
    QComboBox::hidePopup();
    // activated() comes right after the list has gone; the arrow keys on the closed box emit it, too.
    QMetaObject::invokeMethod(
        this, [this] { m_listOpen = false; }, Qt::QueuedConnection);
}

} // namespace lds::ui
