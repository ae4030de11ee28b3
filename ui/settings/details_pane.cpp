#include "details_pane.h"

#include "detail_texts.h"
#include "rule_texts.h"
#include "settings_model.h"
#include "theme.h"
#include "window_sketch.h"

#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QVBoxLayout>

namespace lds::ui {

using catalog::ItemId;

namespace {

constexpr int iconSize = 16;

bool hasWindow(const SettingRow& row)
{
    if (!row.first())
        return false;
    switch (row.first()->id) {
    case ItemId::HighSetValue:
    case ItemId::LowSetValue:
    case ItemId::Hysteresis:
    case ItemId::Tolerance:
        return true;
    default:
        return false;
    }
}

QString paragraphs(const QStringList& lines)
{
    return QStringLiteral("<p style='margin:0 0 4px 0'>") +
           lines.join(QStringLiteral("</p><p style='margin:0 0 4px 0'>")) + QStringLiteral("</p>");
}

} // namespace

DetailsPane::DetailsPane(SettingsModel& model, QWidget* parent)
    : QScrollArea(parent)
    , m_model(model)
{
    setObjectName(QStringLiteral("details"));
    setAccessibleName(tr("Details of the chosen item"));
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setMinimumWidth(56 * Theme::unit);
    build();
    applyTheme();
    refresh();
    connect(&Theme::instance(), &Theme::changed, this, &DetailsPane::applyTheme);
    connect(&model, &QAbstractItemModel::dataChanged, this, [this](const QModelIndex& changed) {
        // Rules name the numbers of other rows: those near are looked at now, the rest once for all.
        if (m_index.isValid() && changed.parent() == m_index.parent())
            refresh();
        else
            refreshLater();
    });
}

QLabel* DetailsPane::addLabel(QVBoxLayout* layout, const char* property)
{
    auto* label = new QLabel(widget());
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    if (property)
        label->setProperty(property, true);
    layout->addWidget(label);
    return label;
}

DetailsPane::Section DetailsPane::addSection(QVBoxLayout* layout, const QString& heading)
{
    Section section;
    layout->addSpacing(Theme::unit);
    section.heading = addLabel(layout, "heading");
    section.heading->setText(heading);
    section.text = addLabel(layout);
    section.text->setTextFormat(Qt::RichText);
    return section;
}

DetailsPane::Notice DetailsPane::addNotice(QVBoxLayout* layout, const QString& objectName,
                                           const QList<QPushButton*>& buttons)
{
    Notice notice;
    notice.frame = new QFrame(widget());
    notice.frame->setObjectName(objectName);
    notice.icon = new QLabel(notice.frame);
    notice.text = new QLabel(notice.frame);
    notice.text->setWordWrap(true);
    notice.text->setTextFormat(Qt::PlainText);
    notice.buttons = buttons;
    auto* column = new QVBoxLayout(notice.frame);
    column->setContentsMargins(2 * Theme::unit, 2 * Theme::unit, 2 * Theme::unit, 2 * Theme::unit);
    auto* line = new QHBoxLayout;
    line->setSpacing(2 * Theme::unit);
    line->addWidget(notice.icon, 0, Qt::AlignTop);
    line->addWidget(notice.text, 1);
    column->addLayout(line);
    auto* actions = new QHBoxLayout;
    actions->setSpacing(Theme::unit);
    for (QPushButton* button : buttons)
        actions->addWidget(button);
    actions->addStretch(1);
    column->addLayout(actions);
    layout->addWidget(notice.frame);
    return notice;
}

void DetailsPane::build()
{
    setWidget(new QWidget(this));
    auto* layout = new QVBoxLayout(widget());
    layout->setContentsMargins(4 * Theme::unit, 3 * Theme::unit, 4 * Theme::unit, 3 * Theme::unit);
    layout->setSpacing(Theme::unit);
    m_empty = addLabel(layout, "muted");
    m_empty->setText(tr("Choose an item to see what it is, which rules hold it and which address has it."));
    m_path = addLabel(layout, "muted");
    m_title = addLabel(layout, "title");
    auto* putRight = new QPushButton(tr("Put it right"));
    auto* keepMine = new QPushButton(tr("Keep mine"));
    auto* takeSensors = new QPushButton(tr("Take the sensor's"));
    keepMine->setObjectName(QStringLiteral("keepMine"));
    takeSensors->setObjectName(QStringLiteral("takeSensors"));
    connect(putRight, &QPushButton::clicked, this, [this] { Q_EMIT editRequested(row()); });
    connect(keepMine, &QPushButton::clicked, this, [this] { Q_EMIT keepMineRequested(row()); });
    connect(takeSensors, &QPushButton::clicked, this, [this] { Q_EMIT takeSensorsRequested(row()); });
    m_wrong = addNotice(layout, QStringLiteral("wrongNotice"), {putRight});
    m_conflict = addNotice(layout, QStringLiteral("conflictNotice"), {keepMine, takeSensors});
    m_problem = addNotice(layout, QStringLiteral("problemNotice"), {});
    m_whyNot = addNotice(layout, QStringLiteral("whyNotNotice"), {});
    m_help = addLabel(layout);
    m_help->setTextFormat(Qt::PlainText);
    m_rules = addSection(layout, tr("RULES"));
    m_sketch = new WindowSketch(widget());
    layout->addWidget(m_sketch);
    m_change = addSection(layout, tr("CHANGE"));
    m_values = addSection(layout, tr("RANGE AND DEFAULT"));
    m_addresses = addSection(layout, tr("ADDRESSES"));
    m_manual = addLabel(layout, "muted");
    layout->addStretch(1);
}

void DetailsPane::applyTheme()
{
    const auto& theme = Theme::instance();
    const auto paint = [&theme](const Notice& notice, const QString& icon, ColorRole role,
                                ColorRole background) {
        notice.icon->setPixmap(theme.icon(icon, role).pixmap(iconSize, iconSize));
        notice.frame->setStyleSheet(
            QStringLiteral("QFrame#%1 { background: %2; border: 1px solid %3; border-radius: 4px; }")
                .arg(notice.frame->objectName(), theme.color(background).name(), theme.color(role).name()));
    };
    paint(m_wrong, QStringLiteral("state-error"), ColorRole::Error, ColorRole::Panel);
    paint(m_conflict, QStringLiteral("conflict"), ColorRole::EditBar, ColorRole::Edit);
    paint(m_problem, QStringLiteral("state-warning"), ColorRole::EditBar, ColorRole::Edit);
    paint(m_whyNot, QStringLiteral("info"), ColorRole::Muted, ColorRole::Background);
    setStyleSheet(
        QStringLiteral("QScrollArea#details { background: %1; border: none; border-left: 1px solid %2; }"
                       "QScrollArea#details:focus { border-left: 2px solid %3; }"
                       "QScrollArea#details > QWidget > QWidget { background: %1; }")
            .arg(theme.color(ColorRole::Panel).name(), theme.color(ColorRole::Line).name(),
                 theme.color(ColorRole::Accent).name()));
}

const SettingRow* DetailsPane::row() const { return m_model.row(m_index); }

void DetailsPane::setRow(const QModelIndex& sourceIndex)
{
    if (m_index != sourceIndex)
        verticalScrollBar()->setValue(0);
    m_index = sourceIndex;
    refresh();
}

void DetailsPane::sessionChanged()
{
    m_index = QModelIndex();
    m_sketch->setSession(m_model.session());
    refresh();
}

void DetailsPane::show(const Section& section, const QStringList& lines)
{
    section.heading->setVisible(!lines.isEmpty());
    section.text->setVisible(!lines.isEmpty());
    section.text->setText(lines.isEmpty() ? QString() : paragraphs(lines));
}

void DetailsPane::show(const Notice& notice, const QString& text) const
{
    notice.text->setText(text);
    notice.frame->setVisible(!text.isEmpty());
}

void DetailsPane::refresh()
{
    const SettingRow* row = this->row();
    m_empty->setVisible(!row);
    for (QLabel* label : {m_path, m_title, m_help, m_manual})
        label->setVisible(row);
    if (!row || !m_model.session()) {
        for (const Section& section : {m_rules, m_change, m_values, m_addresses})
            show(section, {});
        for (const Notice& notice : {m_wrong, m_conflict, m_problem, m_whyNot})
            show(notice, {});
        m_sketch->hide();
        return;
    }
    m_path->setText(detail_texts::path(*row));
    m_title->setText(row->title());
    m_help->setText(detail_texts::help(*row));
    m_help->setVisible(!m_help->text().isEmpty());
    m_manual->setText(detail_texts::manual(*row));
    m_manual->setVisible(!m_manual->text().isEmpty());
    refreshNotices(*row);
    refreshSections(*row);
}

void DetailsPane::refreshLater()
{
    if (m_refreshQueued)
        return;
    m_refreshQueued = true;
    QMetaObject::invokeMethod(
        this,
        [this] {
            m_refreshQueued = false;
            refresh();
        },
        Qt::QueuedConnection);
}

void DetailsPane::refreshNotices(const SettingRow& row)
{
    const auto states = m_model.states(row);
    const auto wrong = m_model.wrongInput(row);
    show(m_wrong, wrong.text.isEmpty() ? QString() : wrong.message);
    show(m_conflict, states.testFlag(SettingsModel::Conflict)
                         ? detail_texts::conflict(row, *m_model.session())
                         : QString());
    show(m_problem, m_model.problems(row).join(u'\n'));
    show(m_whyNot, RowFacts(row, *m_model.session()).whyNot());
}

void DetailsPane::refreshSections(const SettingRow& row)
{
    const auto& session = *m_model.session();
    QStringList rules;
    for (const QString& rule : ruleTexts(row, session))
        rules += rule.toHtmlEscaped();
    show(m_rules, rules);
    m_sketch->setVisible(hasWindow(row) && session.held(ItemId::HighSetValue) &&
                         session.held(ItemId::LowSetValue));
    const bool hasItem = row.first();
    const RowFacts facts(row, session);
    m_change.heading->setText(facts.isEdited() ? tr("CHANGE") : facts.isKnown() ? tr("VALUE") : tr("EFFECT"));
    show(m_change, hasItem ? detail_texts::change(row, session) : QStringList());
    show(m_values, hasItem ? detail_texts::rangeAndDefault(row, session) : QStringList());
    show(m_addresses, detail_texts::addresses(row));
}

QString DetailsPane::plainText() const
{
    QStringList parts;
    for (const QLabel* label : widget()->findChildren<QLabel*>()) {
        if (label->isVisibleTo(widget()))
            parts += label->text();
    }
    return parts.join(u'\n');
}

} // namespace lds::ui
